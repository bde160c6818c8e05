// Loops of a description: whether they can be meant, and their frames in the model.
#pragma once

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// A loop that misses by more than this along a held direction does not close.
inline constexpr double loop_miss_m = 1e-3;           ///< m
inline constexpr double loop_miss_rad = 1.745329e-3;  ///< rad, 0.1 degrees

/// Notes what is wrong with the loops of a tree, by names alone.
void check_loops(const TreeSpec& tree, Findings& findings);

/// Adds the loops of a checked tree and their frames to its model. Throws Error where a frame's
/// name is taken, or where a loop ties a body to itself that it does not fit.
void add_loops(const TreeSpec& tree, Model& model);

/// How far a loop with the second frame there in the first is from closed, along its directions.
struct LoopDistance {
  double translation = 0.0;  ///< m
  double rotation = 0.0;     ///< rad
  bool closes() const { return translation <= loop_miss_m && rotation <= loop_miss_rad; }
  std::string text() const;  ///< "2.3 mm and 0.4 degrees", of what is above 1e-6
};
LoopDistance loop_distance(const Directions& directions, const Eigen::Isometry3d& second_in_first);

}  // namespace burnish
