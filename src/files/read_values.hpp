// Reads values that several parts of a problem file contain: references, postures and rows.
#pragma once

#include "document/geometry.hpp"
#include "files/problem_scope.hpp"

namespace burnish::files {

using document::read_placement;
using document::read_rotation;
/// Reads a reference:
///  - a word: local, centered, world or surface;
///  - {surface: ...} or {local: ...} with a rotation ({normal: [...]}, {rpy: [...]}, ...);
///  - {surface: ...} with a curved surface;
///  - {origin: ..., axes: ...}, each tool, base, world or the name of a frame, with an optional
///    rotation or curved surface.
/// Missing keys keep the values of `otherwise`, or of Reference::on for a curved surface. In
/// problems, a rotation can also be {over_time: path}, with tables in the folder `tables`.
Reference read_reference(const Reader& reader, const Reference& otherwise = Reference::centered(),
                         const std::filesystem::path* tables = nullptr);
/// Reads axes, returned as columns: {normal: [...]}, {rpy: [...]}, {quaternion: [...]} or
/// {matrix: [...]}.
Eigen::Matrix3d read_axes(const Reader& reader);
/// Reads a word of Directions::parse, or a list of such words: linear, pad_z, [x, y].
Directions read_directions(const Reader& reader);
/// Reads a configuration: the name of a posture, {from: name, joint: value or values, ...}, or nq
/// numbers. Joints without a value take it from the posture `from`, else from `others`, else from
/// the default posture.
Eigen::VectorXd read_configuration(const Robot& robot, const Reader& reader,
                                   const std::optional<Posture>& others = std::nullopt);
/// Reads one number for all rows, a list, or {name: number or list, ..., other: number}. Rows
/// without a value are `otherwise`.
Eigen::VectorXd read_rows(const Reader& reader, const std::vector<RowGroup>& groups,
                          double otherwise);
/// Returns the total number of rows.
int rows_of(const std::vector<RowGroup>& groups);
/// Returns one group per joint: its entries of v. A joint that follows another joint has no group.
std::vector<RowGroup> velocity_rows(const Model& model);

/// Returns the path of a file name in a problem file: relative names start from `folder`.
std::filesystem::path beside(const std::filesystem::path& folder, const std::string& name);

}  // namespace burnish::files
