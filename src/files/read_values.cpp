#include "files/read_values.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/model/state.hpp"
#include "document/text.hpp"

namespace burnish::files {
namespace {

Eigen::Quaterniond from_rpy(const Eigen::Vector3d& rpy) {
  return Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
}

Eigen::Quaterniond quaternion_of(const YamlReader& reader) {
  const Eigen::Vector4d xyzw = reader.numbers(4);
  // Files are rounded.
  if (std::abs(xyzw.norm() - 1.0) > 1e-3)
    reader.refuse("the quaternion has length " + number(xyzw.norm()) + "; wanted 1");
  return Eigen::Quaterniond(Eigen::Vector4d(xyzw.normalized()));
}

Eigen::Matrix3d matrix_of(const YamlReader& reader) {
  const std::vector<YamlReader> rows = reader.entries();
  if (rows.size() != 3) reader.refuse("it has " + std::to_string(rows.size()) + " rows; wanted 3");
  Eigen::Matrix3d R;
  for (int i = 0; i < 3; ++i) R.row(i) = rows[static_cast<std::size_t>(i)].vector3();
  if ((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() > 1e-6 || R.determinant() < 0.0)
    reader.refuse("it is not a rotation matrix");
  return R;
}

/// The rotation of a map with rpy, quaternion or matrix, or the identity.
Eigen::Quaterniond rotation_in(const YamlReader& reader) {
  if (int(reader.has("rpy")) + int(reader.has("quaternion")) + int(reader.has("matrix")) > 1)
    reader.refuse("more than one of the keys rpy, quaternion and matrix is stated; state one");
  if (reader.has("rpy")) return from_rpy(reader["rpy"].vector3());
  if (reader.has("quaternion")) return quaternion_of(reader["quaternion"]);
  if (reader.has("matrix")) return Eigen::Quaterniond(matrix_of(reader["matrix"]));
  return Eigen::Quaterniond::Identity();
}

/// The same as a matrix, which is not rounded where it is stated as one.
Eigen::Matrix3d axes_in(const YamlReader& reader) {
  const Eigen::Quaterniond rotation = rotation_in(reader);
  return reader.has("matrix") ? matrix_of(reader["matrix"]) : rotation.toRotationMatrix();
}

/// A new value of a joint puts those that move with it elsewhere.
void forget_coupled(const Model& model, const std::string& name, Posture& posture) {
  const auto& joints = model.joints;
  const auto found = std::find_if(joints.begin(), joints.end(),
                                  [&](const Joint& joint) { return joint.name == name; });
  if (found == joints.end()) return;
  for (const Joint& joint : joints)
    if (joint.v_index == found->v_index && (joint.follows || found->follows))
      posture.erase(joint.name);
}

}  // namespace

Eigen::Isometry3d read_placement(const YamlReader& reader, const std::vector<std::string>& also) {
  std::vector<std::string> keys{"xyz", "rpy", "quaternion", "matrix"};
  keys.insert(keys.end(), also.begin(), also.end());
  reader.allow_only(keys);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (const auto xyz = reader.find("xyz")) result.translation() = xyz->vector3();
  result.linear() = axes_in(reader);
  return result;
}

Eigen::Quaterniond read_rotation(const YamlReader& reader) {
  if (reader.is_list()) return quaternion_of(reader);
  reader.allow_only({"rpy", "quaternion", "matrix"});
  return rotation_in(reader);
}

Reference read_reference(const YamlReader& reader) {
  if (!reader.is_map()) return reader.named([&] { return Reference::parse(reader.text()); });
  if (const auto type = reader.find("type")) {
    // As requests stated it up to version 0.2.
    std::string axes =
        "\"normal\": " +
        (reader.has("normal") ? document::one_line(reader["normal"].node()) : "[x, y, z]");
    if (reader.has("rotation"))
      axes = "\"matrix\": " + document::one_line(reader["rotation"].node());
    type->refuse("a reference has no type beside its axes; wanted {\"" + type->text() + "\": {" +
                 axes + "}}");
  }
  reader.allow_only({"surface", "local"});
  if (reader.has("surface") && reader.has("local"))
    reader.refuse("keys 'surface' and 'local' are both stated; state one");
  const bool surface = reader.has("surface");
  const YamlReader axes = reader[surface ? "surface" : "local"];
  axes.allow_only({"normal", "rpy", "quaternion", "matrix"});
  if (const auto normal = axes.find("normal")) {
    if (!surface || axes.items().size() > 1)
      axes.refuse("a normal goes with 'surface' and stands alone");
    return normal->named([&] { return Reference::surface_with_normal(normal->vector3()); });
  }
  const Eigen::Matrix3d rotation = axes_in(axes);
  return surface ? Reference::surface(rotation) : Reference::local(rotation);
}

Eigen::Matrix3d read_axes(const YamlReader& reader) {
  reader.allow_only({"normal", "rpy", "quaternion", "matrix"});
  const auto normal = reader.find("normal");
  if (!normal) return axes_in(reader);
  if (reader.items().size() > 1) reader.refuse("a normal stands alone");
  return normal->named([&] { return Reference::surface_with_normal(normal->vector3()).rotation; });
}

Eigen::VectorXd read_configuration(const Robot& robot, const YamlReader& reader,
                                   const std::optional<Posture>& others) {
  if (reader.is_list()) {
    const Eigen::VectorXd q = reader.numbers(robot.model.nq);
    reader.named([&] { check_configuration(robot.model, q); });
    return q;
  }
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
  for (const auto& [joint, value] : reader.items()) {
    if (joint == "from") continue;
    if (value.is_list()) {
      const Eigen::VectorXd values = value.numbers();
      posture[joint] = {values.begin(), values.end()};
    } else {
      posture[joint] = {value.number()};
    }
  }
  return reader.named([&] { return configuration(robot.model, posture); });
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

Eigen::VectorXd read_rows(const YamlReader& reader, const std::vector<RowGroup>& groups,
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
