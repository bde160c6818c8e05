// Vectors, matrices and placements as JSON, and JSON as readable text.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "burnish/base/views.hpp"

namespace burnish {

/// JSON whose entries keep the order in which they were added.
using Json = nlohmann::ordered_json;

/// Returns a number; null if it is missing or not finite, because JSON does not have infinity.
Json number_json(double value);
Json number_json(const std::optional<double>& value);
/// Returns a list. Entries that are not finite become null.
Json numbers_json(const Eigen::Ref<const Eigen::VectorXd>& values);
/// Returns a list of rows.
Json matrix_json(const Eigen::Ref<const Eigen::MatrixXd>& matrix);
/// Returns {"xyz": [x, y, z], "quaternion": [x, y, z, w]}, with `xyz` in metres and w >= 0.
Json placement_json(const Eigen::Isometry3d& placement);

/// Returns indented text with full precision. Lists of plain values are on one line.
std::string json_text(const Json& value);

}  // namespace burnish
