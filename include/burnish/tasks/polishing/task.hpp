// The polishing task as a plain value: all that a task file may say, with its defaults.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/polishing/path.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish::polishing {

/// Axes that the contact and its force are written in.
enum class ForceAxes {
  Surface,  ///< the surface's own: x, y along it, z out of it (the paper's centred frame where the
            ///< surface is aligned with the world)
  Local,    ///< the tool's: its axis that is closest to the normal at the start
};

/// Cost weights, per second of horizon. Each is (what it buys): doubling it halves the error that
/// the others force on its term.
struct Weights {
  double posture = 0.1;   ///< 1/rad^2: keeps the null space near the starting posture
  double velocity = 1.0;  ///< s^2/rad^2: damps the joints
  double torque = 1e-4;   ///< 1/Nm^2: of the control, about the torque that holds the posture
  double position = 1e4;  ///< 1/m^2: of the tool along the surface (all three axes in the reach)
  double approach = 1e2;  ///< s^2/m^2: of the tool's speed towards the surface and off it
  double rotation = 1.0;  ///< 1/rad^2: of the tool
  double force = 1.0;     ///< 1/N^2
  double position_limits = 1e3;  ///< 1/rad^2 beyond a joint's limit minus its margin
  double velocity_limits = 1e2;  ///< s^2/rad^2 beyond a joint's velocity limit
  double torque_limits = 1.0;    ///< 1/Nm^2 beyond a joint's effort limit
  double terminal = 0.1;         ///< s: terminal costs are the running ones times this
};

/// What "polished" asks for, of the plant's true force and place, from the end of the ramp to the
/// end of the path.
struct Verdict {
  double contact_share = 0.99;  ///< of that time in contact, at least; 0 to 1
  /// Of Task::force: the root mean square of the error of the force's mean over 10 ms, at most;
  /// infinite: any.
  double force_rmse = 0.1;
  /// Of the path's length, at least; 0 to 1: what the tool went along, nearer to its target than
  /// its tip's radius. A path without end is as long as Task::polish_duration makes it.
  double path_share = 0.99;
};

/// What a posture that is searched has to keep to; see find_posture().
struct PostureLimits {
  double tilt = 1.0;            ///< rad between the pressing axis and the normal's opposite
  double joint_margin = 0.15;   ///< rad (m) that joints keep from their limits at the start
  double body_distance = 0.25;  ///< m between the last link and the robot's body
};

struct Task {
  std::string robot = "talos:right_arm";
  /// Of the robot's settings: start and null space; "search": find_posture(). Empty: the robot's
  /// default, or searched where it has none. So is a named surface's, where the robot has none of
  /// that name.
  std::string posture = {};
  PostureLimits search = {};
  std::string tool = "tool";
  /// That the tool presses along, in its frame, any length; none: see pressing_direction().
  std::optional<Eigen::Vector3d> tool_axis = {};
  double tip_radius = 0.02;  ///< m

  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< out of the surface
  /// A point of the surface, m; none: it lies `clearance` under the tool at the start.
  std::optional<Eigen::Vector3d> point_world = {};
  /// m that there is surface beyond the path, on all four sides of a square about the path's
  /// origin; infinite: it has no end.
  double extent = 0.1;
  double friction = 0.0;   ///< of the surface in the plant; the controller does not know it
  double stiffness = 1e5;  ///< N/m
  double damping = 500.0;  ///< Ns/m

  double force = 30.0;  ///< N
  /// N, at once where contact is made, so that the tool does not rebound; the ramp starts there.
  double touch_force = 6.0;
  PathSpec path = {};
  double clearance = 0.02;        ///< m of the tool above the surface where the reach ends
  double reach_duration = 0.5;    ///< s
  double approach_speed = 0.03;   ///< m/s
  double ramp_duration = 0.5;     ///< s
  double polish_duration = 12.6;  ///< s on the path
  double retreat_duration = 0.5;  ///< s
  Verdict verdict = {};

  double horizon = 1.0;         ///< s
  double step = 0.01;           ///< s
  double update_rate = 1000.0;  ///< Hz
  double tick_rate = 2000.0;    ///< Hz
  double solver_delay = 0.0;    ///< s
  int iterations = 1;           ///< per update
  StepUpdate solver = StepUpdate::MultipleShooting;
  double contact_kd = 40.0;  ///< 1/s, Baumgarte
  /// rad/s; 0: torques are the control, no torque state.
  double torque_cutoff = 0.0;
  ForceAxes axes = ForceAxes::Surface;
  bool feedback = true;  ///< Riccati policy between updates
  ModelErrorOptions model_error = {.bandwidth = 150.0};
  SafetyLimits limits = {};
  ToolLimits tool_limits = {};
  double contact_threshold = 2.0;  ///< N of measured normal force that count as contact
  Fallback fallback = {};
  Weights weights = {};

  Disturbances disturbances = {};
};

}  // namespace burnish::polishing
