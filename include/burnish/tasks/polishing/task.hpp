// The polishing task as a plain value: all that a task file may say, with its defaults.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/polishing/force_profile.hpp"
#include "burnish/tasks/polishing/path.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::polishing {

using burnish::HomeSpec;
using burnish::PostureLimits;

/// Axes that the contact and its force are written in.
enum class ForceAxes {
  Surface,  ///< the surface's own: x, y along it, z out of it (the paper's centred frame where the
            ///< surface is aligned with the world)
  Local,    ///< the tool's: its axis that is closest to the normal at the start
  World,    ///< the world's: those of the surface at the start, which stay where they are
};

/// How the robot itself moves the frame that carries the surface: from where it starts by shift * s
/// and turn * s (a rotation vector), s = sin(2 pi frequency t) from contact on.
struct Waving {
  Eigen::Vector3d shift_world = Eigen::Vector3d::Zero();  ///< [x, y, z] m, world
  Eigen::Vector3d turn_world = Eigen::Vector3d::Zero();   ///< [x, y, z] rad, world
  double frequency = 0.3;                                 ///< Hz
  double start_up = 1.0;                                  ///< s until the full way
  double position = 1e4;  ///< 1/m^2: the frame's origin to where it shall be
  double rotation = 1e3;  ///< 1/rad^2: the frame's axes to what they shall be
};

/// Cost weights, per second of horizon. Each is (what it buys): doubling it halves the error that
/// the others force on its term.
struct Weights {
  /// 1/rad^2: joints to the start; more holds the elbow, costs path accuracy
  double posture = 0.1;
  double velocity = 1.0;  ///< s^2/rad^2: joint speeds; more damps, and lags on fast paths
  double torque = 1e-4;   ///< 1/Nm^2: torques to those that hold the start
  /// 1/m^2: tool to the path, in the reach to the point above the surface; none: fitted to the arm,
  /// see fit_gains()
  std::optional<double> position = {};
  double approach = 1e2;  ///< s^2/m^2: speed along the normal to that of approach and retreat
  /// 1/rad^2: tool to its orientation at the start; less lets the wrist follow
  double rotation = 1.0;
  double force = 1.0;     ///< 1/N^2: force along the normal to its target
  double terminal = 0.1;  ///< s: what the end of the horizon costs, as a time at its running cost
};

/// What "polished" asks for, of the plant's true force and place, from the end of the ramp to the
/// end of the path.
struct Verdict {
  double contact_share = 0.99;  ///< of the time in contact, at least; 0 to 1
  /// of the force: rms error of its mean over 10 ms, at most; infinite: any
  double force_rmse = 0.1;
  /// of the path's length with the tip over its target, at least; 0 to 1. Nearer to it than the
  /// tip's radius. A path without end is as long as Task::polish_duration makes it.
  double path_share = 0.99;
};

struct Task {
  /// a robot's name, folder or settings file, with :variant
  std::string robot = "talos:right_arm";
  /// start of the arm, what its null space is drawn to; search: found for the surface. Of the
  /// robot's settings, or find_posture()'s. Empty: the robot's default, or searched where it has
  /// none. So is a named surface's, where the robot has none of that name.
  std::string posture = {};
  /// joints whose rotor is missing get an armature of 2 ms * effort / velocity. In plans and plant.
  /// Missing: torque noise alone drives the joint past its speed limit; without this a note names
  /// it.
  bool assume_rotors = false;
  PostureLimits search = {};
  HomeSpec home = {};         ///< where a run begins, if not at the start of the arm
  Standing standing = {};     ///< of a robot whose base floats
  std::string tool = "tool";  ///< its origin is the centre of a round tip
  /// that the tool presses along, in its frame, any length; without it see pressing_direction(); a
  /// posture that is given must agree with it, within search.tilt
  std::optional<Eigen::Vector3d> tool_axis = {};
  double tip_radius = 0.02;  ///< m

  /// of the robot, that carries the surface, such as a plate in the other hand; empty: the world
  std::string surface_frame = {};
  Waving waving = {};  ///< of that frame
  /// out of the surface, any length; in the axes of the frame that carries it
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// a point of the surface, m, alike; without it `clearance` under the tool at the start
  std::optional<Eigen::Vector3d> point_world = {};
  SurfaceShape shape = {};  ///< plane, or what the surface is about that point
  /// m that there is surface beyond the path, on all four sides of a square about the path's
  /// origin; infinite: it has no end
  double extent = 0.1;
  /// Coulomb coefficient of the plant, unless disturbances.surface_friction says another
  double friction = 0.0;
  double stiffness = 1e5;  ///< N/m, of the plant
  double damping = 500.0;  ///< Ns/m, of the plant

  double force = 30.0;  ///< N, that the tool presses with
  /// N, at once where contact is made, so that the tool does not rebound; the ramp starts there
  double touch_force = 6.0;
  ForceProfile force_profile = {};
  PathSpec path = {};
  double clearance = 0.02;        ///< m between tool and surface where the reach ends
  double reach_duration = 0.5;    ///< s
  double approach_speed = 0.03;   ///< m/s towards the surface
  double ramp_duration = 0.5;     ///< s from contact to the full force
  double polish_duration = 12.6;  ///< s on the path
  double retreat_duration = 0.5;  ///< s back to the clearance
  Verdict verdict = {};

  double horizon = 1.0;  ///< s that are planned ahead
  double step = 0.01;    ///< s between two knots of the plan
  /// of the plan: their steps grow from the first one, so that few look as far ahead; 0: all are
  /// alike
  int knots = 0;
  double update_rate = 1000.0;  ///< Hz, of new plans; divides the tick rate
  double tick_rate = 2000.0;    ///< Hz, of torque commands
  /// fixed: plans are used solver_delay after their measurement; measured: the time that each takes
  /// passes, in simulations too; thread: they are made in a thread of their own
  PlanTiming timing = PlanTiming::Fixed;
  double solver_delay = 0.0;  ///< s from a measurement to the use of the plan made from it
  /// s from a command to the torque that it makes, as far as it is known. Rounded to ticks. Plans
  /// and feedback begin in the state that the torques already sent lead to.
  double command_delay = 0.0;
  /// s from what is measured to the tick that has it, as far as it is known
  double measurement_delay = 0.0;
  double slowdown = 1.0;  ///< of measured timing: a machine by this factor slower
  int iterations = 1;     ///< of the solver, per plan
  StepUpdate solver = StepUpdate::MultipleShooting;  ///< multiple_shooting or rollout
  double contact_kd = 40.0;  ///< 1/s, damping of the contact constraint (Baumgarte)
  /// m/s of sliding below which the friction of plans fades: their steps bear no less
  double friction_speed = 0.1;
  /// rad/s, torque lag that plans know of; 0: none; the plant's is in disturbances
  double torque_cutoff = 0.0;
  ForceAxes axes =
      ForceAxes::Surface;  ///< of contact and force: surface, local (the tool's) or world
  bool feedback = true;    ///< between plans follow their Riccati gains, not just their torques
  /// bandwidth, boost, lag and force_gain that are none are fitted to the arm, see fit_gains()
  ModelErrorOptions model_error = {.calm = 0.25, .sliding_bandwidth = 360.0};
  SurfaceEstimateOptions surface_estimate = {};
  /// of the tool on the surface; plans know friction, by this coefficient
  FrictionEstimateOptions friction_estimate = {.enabled = false};
  SafetyLimits limits = {.torque_gap = 0.25};
  ToolLimits tool_limits = {};
  /// N that count as contact. Where the sensor's noise comes near it, which is found out in the
  /// reach, it is the mean over 5 ms that counts, against six of its own deviations.
  double contact_threshold = 2.0;
  /// false: the force is told from torques, encoders and velocities, against what they said in the
  /// air just before
  bool force_sensor = true;
  Fallback fallback = {};
  Weights weights = {};
  PlanLimits constraints = {};

  ImpedanceGains baseline = {};     ///< of the controller `baseline`
  AdmittanceGains admittance = {};  ///< of the controller `admittance`

  Disturbances disturbances = {};
};

}  // namespace burnish::polishing
