#include "files/read_values.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/model/state.hpp"
#include "document/text.hpp"
#include "files/read_target.hpp"

namespace burnish::files {
namespace {

/// Reads axes and returns them as columns. The map may also have the keys `others`.
Eigen::Matrix3d columns_of(const Reader& reader, std::vector<std::string> others) {
  others.insert(others.end(), {"normal", "rpy", "quaternion", "matrix"});
  reader.allow_only(others);
  const auto normal = reader.find("normal");
  if (!normal) return document::axes_in(reader);
  if (reader.has("rpy") || reader.has("quaternion") || reader.has("matrix"))
    reader.refuse(
        "key 'normal' excludes 'rpy', 'quaternion' and 'matrix'; wanted only one of these keys");
  return normal->named([&] { return Reference::surface_with_normal(normal->vector3()).rotation; });
}

/// Returns the reference with the rotation that the map states, constant or over time.
Reference turned(Reference reference, const Reader& reader, const std::vector<std::string>& others,
                 const std::filesystem::path* tables) {
  const auto path = reader.find("over_time");
  if (!path) {
    reference.rotation = columns_of(reader, others);
    return reference;
  }
  if (tables == nullptr)
    path->refuse(
        "only optimal control problems support a rotation over time; wanted a constant rotation");
  std::vector<std::string> keys = others;
  keys.emplace_back("over_time");
  reader.allow_only(keys);
  reference.rotation_over_time = read_rotation_over_time(*tables, *path);
  return reference;
}

const std::vector<std::string> shapes{"sphere", "cylinder", "cone", "ellipsoid", "osculating"};

Quadric read_shape(const std::string& kind, const Reader& reader) {
  const auto inside = reader.find("hollow");
  const bool hollow = inside && inside->yes_or_no();
  const auto point = [&](const char* key) { return reader[key].vector3(); };
  return reader.named([&] {
    if (kind == "sphere") {
      reader.allow_only({"center", "radius", "hollow"});
      return Quadric::sphere(point("center"), reader["radius"].positive(), hollow);
    }
    if (kind == "cylinder") {
      reader.allow_only({"point", "axis", "radius", "hollow"});
      return Quadric::cylinder(point("point"), point("axis"), reader["radius"].positive(), hollow);
    }
    if (kind == "cone") {
      reader.allow_only({"apex", "axis", "half_angle", "hollow"});
      return Quadric::cone(point("apex"), point("axis"), reader["half_angle"].positive(), hollow);
    }
    if (kind == "ellipsoid") {
      return Quadric::ellipsoid(point("center"),
                                columns_of(reader, {"center", "semi_axes", "hollow"}),
                                point("semi_axes"), hollow);
    }
    const Eigen::Vector3d k = point("curvature");
    return Quadric::osculating(point("point"), columns_of(reader, {"point", "curvature"}), k[0],
                               k[1], k[2]);
  });
}

/// Reads a reference that follows a curved surface: one of the shapes, the key `near` (a point) and
/// the optional key `along` (the first tangent at this point). The map may also have the keys
/// `others`. Returns nothing if the map states no shape.
std::optional<Reference> read_curved(const Reader& reader, std::vector<std::string> others = {}) {
  for (const std::string& kind : shapes) {
    const auto shape = reader.find(kind);
    if (!shape) continue;
    others.insert(others.end(), {kind, "near", "along"});
    reader.allow_only(others);
    const Quadric surface = read_shape(kind, *shape);
    return reader.named([&] {
      const Eigen::Vector3d near = reader["near"].vector3();
      const auto along = reader.find("along");
      return along ? Reference::on(surface, near, along->vector3()) : Reference::on(surface, near);
    });
  }
  return {};
}

/// Removes the joints that are coupled to joint `name` from a posture, because this joint gets a
/// new value.
void forget_coupled(const Model& model, const std::string& name, Posture& posture) {
  const auto& joints = model.joints;
  const auto found = std::find_if(joints.begin(), joints.end(),
                                  [&](const Joint& joint) { return joint.name == name; });
  if (found == joints.end()) return;
  for (const Joint& joint : joints)
    if (joint.v_index == found->v_index && (joint.follows || found->follows))
      posture.erase(joint.name);
}

/// Reads a configuration from a posture's name or from values by joint.
Eigen::VectorXd read_posture(const Robot& robot, const Reader& reader,
                             const std::optional<Posture>& others) {
  if (!reader.is_map()) return reader.named([&] { return robot.posture(reader.text()); });
  Posture posture;
  if (const auto from = reader.find("from")) {
    from->named([&] { robot.posture(from->text()); });
    posture = robot.postures.at(from->text());
  } else if (others) {
    posture = *others;
  } else if (!robot.default_posture.empty()) {
    posture = robot.postures.at(robot.default_posture);
  }
  for (const auto& item : reader.items()) forget_coupled(robot.model, item.first, posture);
  std::vector<std::string> named;
  for (const auto& [joint, value] : reader.items()) {
    if (joint == "from") continue;
    named.push_back(joint);
    if (value.is_list()) {
      const Eigen::VectorXd values = value.numbers();
      posture[joint] = {values.begin(), values.end()};
    } else {
      posture[joint] = {value.number()};
    }
  }
  return reader.named([&] {
    return named.empty() ? closed_configuration(robot.model, posture)
                         : closed_configuration(robot.model, posture, named);
  });
}

}  // namespace

Reference read_reference(const Reader& reader, const Reference& otherwise,
                         const std::filesystem::path* tables) {
  if (!reader.is_map()) return reader.named([&] { return Reference::parse(reader.text()); });
  if (const auto type = reader.find("type")) {
    // Syntax of references up to version 0.2.
    std::string axes =
        "\"normal\": " +
        (reader.has("normal") ? document::json_text(reader["normal"].node()) : "[x, y, z]");
    if (reader.has("rotation"))
      axes = "\"matrix\": " + document::json_text(reader["rotation"].node());
    type->refuse("a reference has no key 'type'; wanted {\"" + type->text() + "\": {" + axes +
                 "}}");
  }
  if (reader.has("surface") && reader.has("local"))
    reader.refuse("keys 'surface' and 'local' are both stated; state one");
  for (const std::string kind : {"surface", "local"}) {
    const auto axes = reader.find(kind);
    if (!axes) continue;
    if (reader.items().size() > 1)
      reader.refuse("key '" + kind + "' excludes all other keys; wanted no other key");
    if (axes->has("normal") && (kind == "local" || axes->items().size() > 1))
      axes->refuse("key 'normal' is possible only in 'surface' and only without other keys");
    if (kind == "surface" && axes->is_map())
      if (const auto curved = read_curved(*axes)) return *curved;
    return turned(kind == "surface" ? Reference::parse(kind) : Reference::local(), *axes, {},
                  tables);
  }
  const auto anchor = [&](const char* key, const Anchor& unstated) {
    const auto given = reader.find(key);
    return given ? Anchor::parse(given->text()) : unstated;
  };
  if (auto curved = read_curved(reader, {"origin", "axes"})) {
    curved->origin = anchor("origin", curved->origin);
    curved->axes = anchor("axes", curved->axes);
    return *curved;
  }
  return turned({anchor("origin", otherwise.origin), anchor("axes", otherwise.axes)}, reader,
                {"surface", "local", "origin", "axes"}, tables);
}

Eigen::Matrix3d read_axes(const Reader& reader) { return columns_of(reader, {}); }

Directions read_directions(const Reader& reader) {
  std::string words;
  for (const std::string& word : reader.texts()) words += (words.empty() ? "" : ",") + word;
  return reader.named([&] { return Directions::parse(words); });
}

Eigen::VectorXd read_configuration(const Robot& robot, const Reader& reader,
                                   const std::optional<Posture>& others) {
  const Eigen::VectorXd q =
      reader.is_list() ? reader.numbers(robot.model.nq) : read_posture(robot, reader, others);
  reader.named([&] { check_configuration(robot.model, q); });
  return q;
}

std::vector<RowGroup> velocity_rows(const Model& model) {
  std::vector<RowGroup> rows;
  for (const Joint& joint : model.joints)
    if (!joint.follows) rows.push_back({joint.name, joint.nv});
  return rows;
}

int rows_of(const std::vector<RowGroup>& groups) {
  int sum = 0;
  for (const RowGroup& group : groups) sum += group.size;
  return sum;
}

Eigen::VectorXd read_rows(const Reader& reader, const std::vector<RowGroup>& groups,
                          double otherwise) {
  const int rows = rows_of(groups);
  if (reader.is_list()) return reader.numbers(rows);
  if (!reader.is_map()) return Eigen::VectorXd::Constant(rows, reader.number());
  std::vector<std::string> known{"other"};
  for (const RowGroup& group : groups) known.push_back(group.name);
  reader.allow_only(known);
  if (const auto other = reader.find("other")) otherwise = other->number();
  Eigen::VectorXd result = Eigen::VectorXd::Constant(rows, otherwise);
  int row = 0;
  for (const RowGroup& group : groups) {
    if (const auto value = reader.find(group.name)) {
      if (value->is_list()) {
        result.segment(row, group.size) = value->numbers(group.size);
      } else {
        result.segment(row, group.size).setConstant(value->number());
      }
    }
    row += group.size;
  }
  return result;
}

std::filesystem::path beside(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() ? path : folder / path;
}

}  // namespace burnish::files
