#include "document/geometry.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"

namespace burnish::document {
namespace {

Eigen::Quaterniond from_rpy(const Eigen::Vector3d& rpy) {
  return Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
}

Eigen::Quaterniond quaternion_of(const Reader& reader) {
  const Eigen::Vector4d xyzw = reader.numbers(4);
  // Tolerance for rounded numbers in files, chosen by hand.
  if (std::abs(xyzw.norm() - 1.0) > 1e-3)
    reader.refuse("the quaternion has length " + number(xyzw.norm()) + "; wanted 1");
  return Eigen::Quaterniond(Eigen::Vector4d(xyzw.normalized()));
}

Eigen::Matrix3d matrix_of(const Reader& reader) {
  const std::vector<Reader> rows = reader.entries();
  if (rows.size() != 3) reader.refuse("it has " + std::to_string(rows.size()) + " rows; wanted 3");
  Eigen::Matrix3d R;
  for (int i = 0; i < 3; ++i) R.row(i) = rows[to_size(i)].vector3();
  if ((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() > 1e-6 || R.determinant() < 0.0)
    reader.refuse("it is not a rotation matrix; wanted orthonormal rows and determinant 1");
  return R;
}

/// Returns the rotation of the key rpy, quaternion or matrix of a map, or the identity.
Eigen::Quaterniond rotation_in(const Reader& reader) {
  if (int(reader.has("rpy")) + int(reader.has("quaternion")) + int(reader.has("matrix")) > 1)
    reader.refuse("several of the keys rpy, quaternion and matrix are stated; state one");
  if (reader.has("rpy")) return from_rpy(reader["rpy"].vector3());
  if (reader.has("quaternion")) return quaternion_of(reader["quaternion"]);
  if (reader.has("matrix")) return Eigen::Quaterniond(matrix_of(reader["matrix"]));
  return Eigen::Quaterniond::Identity();
}

}  // namespace

Eigen::Matrix3d axes_in(const Reader& reader) {
  const Eigen::Quaterniond rotation = rotation_in(reader);
  return reader.has("matrix") ? matrix_of(reader["matrix"]) : rotation.toRotationMatrix();
}

Eigen::Isometry3d read_placement(const Reader& reader, const std::vector<std::string>& also) {
  std::vector<std::string> keys{"xyz", "rpy", "quaternion", "matrix"};
  keys.insert(keys.end(), also.begin(), also.end());
  reader.allow_only(keys);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (const auto xyz = reader.find("xyz")) result.translation() = xyz->vector3();
  result.linear() = axes_in(reader);
  return result;
}

Eigen::Quaterniond read_rotation(const Reader& reader) {
  if (reader.is_list()) return quaternion_of(reader);
  reader.allow_only({"rpy", "quaternion", "matrix"});
  return rotation_in(reader);
}

}  // namespace burnish::document
