// Vectors, matrices and placements as JSON, and JSON as text that people can read.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "burnish/base/views.hpp"

namespace burnish {

/// What the program writes: entries stay in the order in which they were put in.
using Json = nlohmann::ordered_json;

/// Null where it is not finite or not there: JSON knows no infinity.
Json number_json(double value);
Json number_json(const std::optional<double>& value);
/// A list. Infinite entries become null.
Json numbers_json(const Eigen::Ref<const Eigen::VectorXd>& values);
/// A list of rows.
Json matrix_json(const Eigen::Ref<const Eigen::MatrixXd>& matrix);
/// {"xyz": [m], "quaternion": [x, y, z, w]}, w not negative.
Json placement_json(const Eigen::Isometry3d& placement);

/// Indented, with lists of plain values on one line. Numbers read back as they were.
std::string json_text(const Json& value);

}  // namespace burnish
