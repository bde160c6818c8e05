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
  std::vector<std::string> frames;  ///< origin: centre of the sole (z up) or of the ball
  std::vector<Frame> added;         ///< new frames for `frames`; with_feet() adds them to a robot
  double half_x = 0.0;              ///< half the length of a sole along x of its frame [m]; 0: ball
  double half_y = 0.0;              ///< half the width along y [m]; 0: ball
  double radius = 0.0;              ///< radius of a ball [m]; 0: the feet have soles
  Size size_from = Size::Height;
  std::vector<std::string> notes;  ///< what was assumed or is to be mended, one sentence each

  bool has_soles() const { return half_x > 0.0; }
};

/// Finds the feet at the reference configuration: the two, four or six lowest branch ends that
/// stand opposite each other in pairs. Two legs have soles if each has at least four joints; four
/// or six legs have soles if each has at least five. All other legs have point feet.
///
/// Frames named after a sole, foot, toe or ankle are preferred. If no frame lies at the centre of
/// the sole or ball, `added` holds a new one. Collision geometry is read from Robot::collisions and
/// from primitives among the visuals; meshes are ignored. A last link without geometry and without
/// such a frame ends where a rod of its mass and inertia does. Rotors are not branches.
///
/// Returns nullopt if the robot has no such branches or stands on wheels; `why`, if given, is then
/// the reason. A wheel is named so, or turns without limits at the end of a leg whose other joints
/// have them; if a frame on it is named after a foot, it counts as one.
std::optional<Feet> find_feet(const Robot& robot, std::string* why = nullptr);

/// Returns `robot` with the frames of Feet::added.
Robot with_feet(Robot robot, const Feet& feet);

/// Returns `standing` on those feet, with their sizes.
Standing with_feet(Standing standing, const Feet& feet);

/// Returns a description such as
/// "left_sole, right_sole (found), soles of 0.2 x 0.1 m, from collision geometry".
std::string feet_text(const Feet& feet);

}  // namespace burnish
