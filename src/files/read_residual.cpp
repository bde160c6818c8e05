#include "files/read_residual.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "document/described.hpp"
#include "dynamics/frame.hpp"
#include "files/residual_target.hpp"
#include "model/followers.hpp"
#include "ocp/descriptions.gen.hpp"
#include "ocp/friction_pyramid.hpp"

namespace burnish::files {
namespace {

template <std::size_t... index>
std::vector<Residual> all_residuals(std::index_sequence<index...> /*of*/) {
  return {Residual(std::variant_alternative_t<index, Residual>{})...};
}

/// Returns the word that files use for the type of a residual, such as frame_position for
/// FramePosition. Empty for a Custom.
std::string type_of_residual(const Residual& residual) {
  const std::string name = std::visit(
      [](const auto& r) -> std::string {
        if constexpr (Described<std::decay_t<decltype(r)>>) return description_of(&r).name;
        return "";
      },
      residual);
  std::string type;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isupper(letter) != 0 && !type.empty()) type += '_';
    type += static_cast<char>(std::tolower(letter));
  }
  return type;
}

/// Returns the residual of a type with its default values.
Residual residual_of(const Reader& type) {
  static const std::vector<Residual> all =
      all_residuals(std::make_index_sequence<std::variant_size_v<Residual>>());
  std::vector<std::string> known;
  for (const Residual& candidate : all)
    if (std::string name = type_of_residual(candidate); !name.empty())
      known.push_back(std::move(name));
  const std::string name = type.word(known);
  for (const Residual& candidate : all)
    if (type_of_residual(candidate) == name) return candidate;
  type.refuse("it is not a type of residual");
}

/// Returns the keys that each state a part of a reference, as alternatives to the key `reference`.
std::vector<std::string> shorter_keys(const auto& /*of*/) { return {}; }
std::vector<std::string> shorter_keys(const residual::FramePosition& /*of*/) { return {"axes"}; }
std::vector<std::string> shorter_keys(const residual::FrameDistance& /*of*/) { return {"axes"}; }
std::vector<std::string> shorter_keys(const residual::FrameVelocity& /*of*/) {
  return {"axes", "rotation"};
}

void read_shorter(const Reader& axes, const std::string& /*key*/, auto& residual) {
  residual.reference = Reference::world(read_axes(axes));
}
void read_shorter(const Reader& part, const std::string& key, residual::FrameVelocity& residual) {
  if (key == "axes")
    residual.reference = Reference::parse(part.word({"local", "centered", "world"}));
  else
    residual.reference.rotation = read_axes(part);
}

/// Checks conditions that a range in the description cannot express.
void check(const auto& /*of*/, const Reader& /*reader*/) {}
void check(const residual::FrictionCone& cone, const Reader& reader) {
  if (const auto sides = reader.find("sides")) sides->named([&] { ocp::check_sides(cone.sides); });
}

document::Reading reading_of(const ProblemScope& scope) {
  document::Reading reading;
  reading.types[typeid(Reference)] = [&scope](void* value, const Reader& reader) {
    auto& reference = *static_cast<Reference*>(value);
    reference = read_reference(reader, reference, &scope.folder);
  };
  reading.types[typeid(Directions)] = [](void* value, const Reader& reader) {
    *static_cast<Directions*>(value) = read_directions(reader);
  };
  reading.names["frame"] = [&scope](const Reader& name) {
    name.named([&] { compile_frame(scope.model(), name.text()); });
  };
  reading.names["contact"] = [&scope](const Reader& name) {
    name.named([&] { (void)ocp::contact_named(scope.spec, name.text()); });
  };
  reading.names["joint"] = [&scope](const Reader& names) {
    const std::vector<std::string> all = names.texts();
    if (all.empty()) names.refuse("the list is empty; wanted at least one joint, or no such key");
    for (const std::string& name : all) {
      if (std::count(all.begin(), all.end(), name) > 1)
        names.refuse("joint " + in_quotes(name) + " is listed twice; wanted each joint once");
      const Model& model = scope.model();
      const Joint& joint =
          model.joints[to_size(names.named([&] { return model.joint_index(name); }))];
      if (joint.follows) names.refuse(that_it_follows(model, joint));
    }
  };
  return reading;
}

}  // namespace

void check_residual_type(const Reader& type) { residual_of(type); }

Residual read_residual(const ProblemScope& scope, const std::vector<std::string>& contacts,
                       const Reader& reader, std::vector<std::string> also) {
  Residual result = residual_of(reader["type"]);
  document::Reading reading = reading_of(scope);
  reading.also = std::move(also);
  std::visit(
      [&](auto& residual) {
        if constexpr (Described<std::decay_t<decltype(residual)>>) {
          if constexpr (requires { residual.target; }) reading.also.emplace_back("target");
          for (const std::string& key : shorter_keys(residual)) {
            reading.also.push_back(key);
            const auto stated = reader.find(key);
            if (!stated) continue;
            if (reader.has("reference"))
              reader.refuse("keys 'reference' and '" + key + "' are both stated; state one");
            if constexpr (requires { residual.reference.rotation; })
              read_shorter(*stated, key, residual);
          }
          document::read_described(description_of(&residual), &residual, reader, reading);
          check(residual, reader);
          if constexpr (requires { residual.target; })
            if (const auto target = reader.find("target"))
              residual.target = read_target_of(residual, {scope, contacts, *target});
        }
      },
      result);
  return result;
}

}  // namespace burnish::files
