// Feet of a legged robot, found in its description.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish {

/// Feet of a robot, in pairs from front to rear, the left one of each pair first.
struct Feet {
  /// What the size of a foot was taken from.
  enum class Size {
    Collision,  ///< collision geometry of the description
    Inertia,    ///< box of the foot's mass and inertia
    Height,     ///< fraction of the height of the base
  };
  std::vector<std::string> frames;  ///< soles: centre of the sole, z up; points: centre of the ball
  std::vector<Frame> added;         ///< those of `frames` that the model does not have yet
  double half_x = 0.0;              ///< half the length of a sole along x of its frame [m]; 0: ball
  double half_y = 0.0;              ///< half the width along y [m]; 0: ball
  double radius = 0.0;              ///< of a ball [m]; 0: soles
  Size size_from = Size::Height;

  bool has_soles() const { return half_x > 0.0; }
};

/// Finds the feet at the reference configuration: two, four or six ends of branches that hang
/// lowest and stand opposite each other in pairs. A pair with at least four joints a leg has soles,
/// and so do more legs with at least five joints each; others have point feet. A frame named after
/// a sole, a foot, a toe or an ankle is preferred; where none lies in the middle of the sole or of
/// the ball, `added` holds one. Collision geometry is that of Robot::collisions and primitives
/// among the visuals; meshes are not opened. Returns nothing for a robot without such branches, and
/// for one that stands on wheels.
std::optional<Feet> find_feet(const Robot& robot);

/// Returns `robot` with the frames of Feet::added.
Robot with_feet(Robot robot, const Feet& feet);

/// Returns `standing` on those feet, with their sizes.
Standing with_feet(Standing standing, const Feet& feet);

/// "left_sole, right_sole (found), soles of 0.2 x 0.1 m from collision geometry".
std::string feet_text(const Feet& feet);

}  // namespace burnish
