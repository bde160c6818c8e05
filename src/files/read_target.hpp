// Reads targets: constants, `here` (values at the start), and paths over time.
#pragma once

#include <optional>

#include "files/read_values.hpp"

namespace burnish::files {

/// Meaning of a target's numbers.
struct TargetSpace {
  enum class Kind {
    Plain,      ///< Numbers; one number sets all entries
    Rotation,   ///< Quaternion x, y, z, w
    Placement,  ///< Position and quaternion
  };
  std::vector<RowGroup> rows = {};
  std::optional<Eigen::VectorXd> here = {};  ///< Value at the start, if the residual has one
  Kind kind = Kind::Plain;
  /// Axes of offsets from `here`, as columns in the coordinates of targets. Without these axes, the
  /// offsets are in the coordinates of targets.
  std::optional<Eigen::Matrix3d> offsets = {};

  int size() const { return rows_of(rows); }
  /// Returns the number of quaternion entries at the end of a target: 4, or 0 for Kind::Plain.
  int quaternion_entries() const { return kind == Kind::Plain ? 0 : 4; }
};

/// Reads a target. Names of tables are relative to `folder`. Throws Error with the place if the
/// target does not fit the space.
Signal read_target(const std::filesystem::path& folder, const TargetSpace& space,
                   const Reader& reader);
/// Reads a path of quaternions: {line: ...} or {points: ...}.
Signal read_rotation_over_time(const std::filesystem::path& folder, const Reader& reader);

}  // namespace burnish::files
