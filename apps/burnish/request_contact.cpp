#include "request_contact.hpp"

#include <fmt/format.h>

namespace burnish::app {
namespace {

Directions read_directions(const JsonReader& reader) {
  return reader.named(
      [&] { return Directions::parse(fmt::format("{}", fmt::join(reader.texts(), ","))); });
}

/// One number for all directions, or six.
Vector6 read_gains(const JsonReader& reader) {
  if (reader.is_number()) return Vector6::Constant(reader.number());
  return reader.numbers(6);
}

}  // namespace

Reference read_reference(const JsonReader& reader) {
  if (reader.is_text()) return reader.named([&] { return Reference::parse(reader.text()); });
  reader.allow_only({"type", "rotation", "normal"});
  const JsonReader type = reader["type"];
  Reference reference = type.named([&] { return Reference::parse(type.text()); });
  if (reader.has("normal")) {
    if (type.text() != "surface" || reader.has("rotation")) {
      reader.refuse("a normal goes with type 'surface' and without a rotation");
    }
    return reader["normal"].named(
        [&] { return Reference::surface_with_normal(reader["normal"].numbers(3)); });
  }
  if (reader.has("rotation")) {
    if (type.text() != "surface" && type.text() != "local") {
      reader.refuse("a rotation goes with type 'surface' or 'local'");
    }
    reference.rotation = reader["rotation"].matrix3();
  }
  return reference;
}

ContactSpec read_contact(const JsonReader& reader) {
  reader.allow_only({"name", "tool", "base", "reference", "directions", "acceleration", "error",
                     "kp", "kd", "target"});
  ContactSpec spec;
  spec.tool = reader["tool"].text();
  if (reader.has("name")) spec.name = reader["name"].text();
  if (reader.has("base")) spec.base = reader["base"].text();
  if (reader.has("reference")) spec.reference = read_reference(reader["reference"]);
  if (reader.has("directions")) spec.directions = read_directions(reader["directions"]);
  if (reader.has("acceleration")) {
    const JsonReader kind = reader["acceleration"];
    spec.acceleration = kind.named([&] { return parse_acceleration(kind.text()); });
  }
  if (reader.has("error")) {
    const JsonReader kind = reader["error"];
    spec.error = kind.named([&] { return parse_pose_error(kind.text()); });
  }
  if (reader.has("kp")) spec.kp = read_gains(reader["kp"]);
  if (reader.has("kd")) spec.kd = read_gains(reader["kd"]);
  if (reader.has("target")) spec.target = reader["target"].placement();
  return spec;
}

}  // namespace burnish::app
