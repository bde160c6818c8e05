// Search for the feet of a legged robot in its description.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish {

/// Feet of a robot, in pairs from front to rear. The left foot of each pair comes first. A foot is
/// either a sole (planar foot) or a ball (point foot).
struct Feet {
  /// Source of a foot's size.
  enum class Size {
    Collision,  ///< collision geometry of the description
    Inertia,    ///< box with the foot's mass and inertia
    Height,     ///< fraction of the height of the base
  };
  /// Frames of the feet; each origin is the centre of a sole (z up) or of a ball
  std::vector<std::string> frames;
  /// Frames that are named in `frames` but not in the robot's description; with_feet() adds them
  std::vector<Frame> added;
  /// Half the length of a sole, along x of its frame [m]; 0 if the feet are balls
  double half_x = 0.0;
  /// Half the width of a sole, along y of its frame [m]; 0 if the feet are balls
  double half_y = 0.0;
  double radius = 0.0;  ///< Radius of a ball [m]; 0 if the feet are soles
  /// Source of the size of the feet
  Size size_from = Size::Height;
  /// Assumptions about the feet, and defects of the description to correct; one sentence each
  std::vector<std::string> notes;

  bool has_soles() const { return half_x > 0.0; }
};

/// Finds the feet of a robot at its reference configuration. Feet are the lowest two, four or six
/// ends of the kinematic tree's branches. These ends must form pairs that stand opposite each
/// other. Two legs have soles if each has at least four joints. Four or six legs have soles if each
/// has at least five joints. All other legs have point feet.
///
/// Frames named after a sole, foot, toe or ankle are preferred. If no frame lies at the centre of
/// the sole or ball, Feet::added contains a new frame there. Collision geometry comes from
/// Robot::collisions and from primitives among the visuals; meshes are ignored. If a leg's last
/// link has neither geometry nor a frame named after a foot, a rod with the link's mass and inertia
/// represents the link. The leg then ends at the end of the rod. Rotors do not count as branches.
///
/// Returns nullopt if the robot has no feet of this kind or stands on wheels. The reason is then
/// written to `why`, unless `why` is null. A link counts as a wheel if its name says so. The last
/// link of a leg also counts as a wheel if it turns without limits while the other joints of the
/// leg have limits, unless a frame of the link is named after a foot.
std::optional<Feet> find_feet(const Robot& robot, std::string* why = nullptr);

/// Returns `robot` with the additional frames Feet::added.
Robot with_feet(Robot robot, const Feet& feet);

/// Returns the settings `standing` with the frames and sizes of `feet`.
Standing with_feet(Standing standing, const Feet& feet);

/// Returns a text that describes the feet, such as "left_sole, right_sole (found), soles of 0.2 x
/// 0.1 m, from collision geometry".
std::string feet_text(const Feet& feet);

}  // namespace burnish
