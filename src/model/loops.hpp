// Loops of a description: checks, and their frames in the model.
#pragma once

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

// Largest closure error of a closed loop, along its constrained directions; chosen by hand.
inline constexpr double loop_miss_m = 1e-3;           ///< Translation [m]
inline constexpr double loop_miss_rad = 1.745329e-3;  ///< Rotation, 0.1 degrees [rad]

/// Reports invalid names, links, directions and placements of the loops of a tree.
void check_loops(const TreeSpec& tree, Findings& findings);

/// Adds the loops of a checked tree and their frames to its model. Throws Error if another frame
/// has the name of a loop's frame, or if a loop connects a body to itself and is open.
void add_loops(const TreeSpec& tree, Model& model);

/// Closure error of a loop along its constrained directions.
struct LoopDistance {
  double translation = 0.0;  ///< Translation [m]
  double rotation = 0.0;     ///< Rotation [rad]
  bool closes() const { return translation <= loop_miss_m && rotation <= loop_miss_rad; }
  /// Returns a text such as "2.3 mm and 0.4 degrees". Leaves out errors below 1e-6 m or rad.
  std::string text() const;
};
/// Returns the closure error for the pose of the loop's second frame in its first frame.
LoopDistance loop_distance(const Directions& directions, const Eigen::Isometry3d& second_in_first);

}  // namespace burnish
