// Small things that several parts of a problem file hold.
#pragma once

#include "document/geometry.hpp"
#include "files/problem_scope.hpp"

namespace burnish::files {

using document::read_placement;
using document::read_rotation;
/// local, centered, world, surface, or {surface: {normal: [...]}}, {surface: {rpy: [...]}} and so
/// on, or {origin: ..., axes: ...}, each tool, base, world or the name of a frame, with the same
/// keys if they are turned, or with a curved surface that the axes follow; what is not said is that
/// of `otherwise`, or for a curved surface of Reference::on. Of a problem, whose tables are
/// in the folder `tables`, {over_time: path} is such a key too.
Reference read_reference(const Reader& reader, const Reference& otherwise = Reference::centered(),
                         const std::filesystem::path* tables = nullptr);
/// Columns of axes: {normal: [...]}, {rpy: [...]}, {quaternion: [...]} or {matrix: [...]}.
Eigen::Matrix3d read_axes(const Reader& reader);
/// A word or a list of them, as Directions::parse has them: linear, pad_z, [x, y].
Directions read_directions(const Reader& reader);
/// A posture's name, or {from: name, joint: value or values, ...}, or nq numbers. Joints that are
/// not stated are as in `others`, or as in the default posture.
Eigen::VectorXd read_configuration(const Robot& robot, const Reader& reader,
                                   const std::optional<Posture>& others = std::nullopt);
/// One number for all rows, a list, or {name: number or list, ..., other: number}.
Eigen::VectorXd read_rows(const Reader& reader, const std::vector<RowGroup>& groups,
                          double otherwise);
int rows_of(const std::vector<RowGroup>& groups);
/// The entries of v by the joints that have some.
std::vector<RowGroup> velocity_rows(const Model& model);

/// The file that a name in a problem file means.
std::filesystem::path beside(const std::filesystem::path& folder, const std::string& name);

}  // namespace burnish::files
