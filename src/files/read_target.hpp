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

  int size() const { return rows_of(rows); }
};

/// Directions as rows: "x", "y", "z", "rx", ...
std::vector<RowGroup> direction_rows(Directions directions);

/// Reads a target. Refuses what does not fit the space.
Signal read_target(const FileScene& scene, const TargetSpace& space, const Reader& reader);

}  // namespace burnish::files
