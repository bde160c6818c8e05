// Targets of costs: constants, where things are at the start, and paths over time.
#pragma once

#include <optional>

#include "files/read_values.hpp"

namespace burnish::files {

/// What a target's numbers are.
struct TargetSpace {
  enum class Kind {
    Plain,      ///< numbers; one number stands for all
    Rotation,   ///< a quaternion x, y, z, w
    Placement,  ///< position and quaternion
  };
  std::vector<RowGroup> rows = {};
  std::optional<Eigen::VectorXd> here = {};  ///< value at the start, where there is one
  Kind kind = Kind::Plain;
  /// Axes that offsets from `here` are along, in the coordinates of the numbers; none: the same.
  std::optional<Eigen::Matrix3d> offsets = {};

  int size() const { return rows_of(rows); }
  /// How many of the last entries are a quaternion.
  int turned() const { return kind == Kind::Plain ? 0 : 4; }
};

/// Reads a target; its tables are in `folder`. Refuses what does not fit the space.
Signal read_target(const std::filesystem::path& folder, const TargetSpace& space,
                   const Reader& reader);
/// {line: ...} or {points: ...}: quaternions.
Signal read_rotation_over_time(const std::filesystem::path& folder, const Reader& reader);

}  // namespace burnish::files
