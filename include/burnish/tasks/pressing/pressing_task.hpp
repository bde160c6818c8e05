// Task for an MpcController: press a tool on a surface. The task detects contact, monitors forces
// and distances, and computes the target.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/estimate/surface_estimate.hpp"
#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Phases of a task that presses with a tool. The tool moves to the surface (Reach), approaches it
/// until contact, ramps up the force, follows a path (Track), and retreats. A Home phase may come
/// before all others; see HomeSpec. Command::phase and traces contain the numbers of the phases.
enum class Phase { Reach, Approach, Ramp, Track, Retreat, Home };

constexpr int number_of(Phase phase) { return static_cast<int>(phase); }
/// Returns "reach", "approach", "ramp", "track", "retreat" or "home".
std::string name_of(Phase phase);
/// Returns the names of all phases. The index of a name is the number of the phase.
const std::vector<std::string>& phase_names();

/// Contact between tool and surface that is expected in a phase.
/// @described pressing
enum class Touch {
  Free,    ///< no contact: a large force is a fault, a smaller force is sensor noise
  Due,     ///< the tool approaches until contact; the phase has SchedulePhase.until "contact"
  Wanted,  ///< the tool presses
  /// the tool leaves the surface; it counts as free when the force is gone, or after
  /// ToolLimits.release
  Leaving,
};

/// Limits on force and motion at the tool. A run is aborted if a limit is exceeded. An infinite
/// value switches a limit off.
/// @described pressing
struct ToolLimits {
  /// Largest mean force at the tool over force_window [N], > 0 or infinite
  /// @more A single sample of the force says little about a rigid impact: the sample is the impulse
  /// divided by the sampling time.
  double force = 100.0;
  /// Averaging time of the force [s], >= 0
  /// @more The time is rounded to ticks, at least one.
  double force_window = 5e-3;
  double tool_speed = 1.0;  ///< Largest speed of the tool [m/s], > 0 or infinite
  /// Longest time without force in phases with contact [s], > 0 or infinite
  double contact_lost = 0.15;
  /// Largest travel along the normal after the planned time of contact [m], > 0 or infinite
  /// @more A surface farther than this behind its assumed position is not reached. The travel
  /// counts from the time when the schedule's clock stops and waits for contact. The clock stops
  /// SchedulePhase.hold seconds before the planned contact.
  double late_contact_travel = 0.03;
  /// Longest wait for contact after the planned time of contact [s], > 0 or infinite
  /// @more The wait begins when the schedule's clock stops and waits for contact.
  double late_contact_time = 3.0;
  /// Largest mean force in free space over force_window [N], > 0 or infinite
  /// @more The limit applies to phases without contact. It also applies to a retreat after the
  /// force fell below the contact threshold, or after the time `release`. If six standard
  /// deviations of the mean's noise are above this limit, they are the limit instead.
  double unexpected_force = 15.0;
  /// Longest time until a retreating tool counts as free [s], > 0 or infinite
  double release = 0.5;
};

/// Hard constraints of plans. An infinite value switches a constraint off.
/// @described pressing
struct PlanLimits {
  /// Smallest distance of joints from their position limits [rad (m)], >= 0 or infinite
  double joint_margin = 0.0;
  /// Largest joint speed, as a fraction of the robot's velocity limits, > 0 or infinite
  double joint_speed = 1.0;
  /// Largest torque, as a fraction of the effort limits, > 0 or infinite
  /// @more Torque commands obey this limit, too.
  double torque = 1.0;
  /// Largest deviation of the force from its target while pressing [N], > 0 or infinite
  /// @more The force itself is never negative, with or without this constraint.
  double force_band = std::numeric_limits<double>::infinity();
  /// Largest rate of torques, as a fraction of the effort limits per second [1/s], > 0 or infinite
  /// @more The constraint requires plans with a torque lag (torque_cutoff).
  double joint_torque_rate = std::numeric_limits<double>::infinity();
};

/// Recorded target of the tool at one time of the schedule. The recorded target has no effect on
/// the motion, which the costs of the problem determine.
/// @described pressing
/// Plans assume friction in proportion to `force`.
struct TaskTarget {
  /// Position of the tool in the frame ToolSpec.base (without such a frame: in the world) [m]
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();
  /// Force along the normal (0: no contact) [N]
  /// @more Without contact, plans assume no friction.
  double force = 0.0;
};

/// Assumed position and shape of the surface under a round tip. The online estimate of the surface
/// starts from these assumptions.
/// @described pressing
/// Point and normal are in the frame ToolSpec::base. If ToolSpec::base is empty, they are in world
/// axes.
struct PressedSurface {
  SurfaceShape shape = {};                               ///< Surface shape about `point_base`
  Eigen::Vector3d point_base = Eigen::Vector3d::Zero();  ///< Point on the surface [m]
  /// Normal of the surface at `point_base`, not zero
  /// @more The normal need not have unit length.
  Eigen::Vector3d normal_base = Eigen::Vector3d::UnitZ();
  double tip_radius = 0.02;              ///< Radius of the round tip [m], > 0
  SurfaceEstimateOptions estimate = {};  ///< Options of the surface estimate
};

/// Task of an MpcSpec that presses with a tool. The task raises the event "contact" if the measured
/// normal force exceeds both the contact threshold and the noise of the sensor. The noise is
/// estimated in free air.
/// @described pressing
/// Assign a PressingTask to MpcSpec::task. If six standard deviations of the noise exceed the
/// threshold, the force is averaged over 5 ms. For contact, the average must then exceed the
/// threshold, and also six standard deviations of the noise that is left after averaging. Faults of
/// this task are SpeedLimit, UnexpectedContact, NoContact, ContactLate, ForceLimit and ContactLost.
struct PressingTask {
  std::vector<Touch> touch = {};  ///< Expected contact in each phase of the schedule
  /// Target as a function of the time of the schedule, in s; required
  /// @more The function is called at each tick.
  std::function<TaskTarget(double time)> target = {};
  ToolLimits limits = {};  ///< Limits on force and motion at the tool
  /// Assumed surface, which is estimated during control; none: surface and normal stay constant
  /// @more Plans use the assumed surface at first, and the estimated surface as soon as the tool
  /// slides. The constant surface and normal come from the specification.
  std::optional<PressedSurface> surface = {};
  /// Scalar input of the problem that receives the schedule's time of the previous tick (empty:
  /// none)
  /// @more A signal that depends on this input can hide the future from plans.
  std::string time_input = {};

  /// Creates the state of this task for a controller of `spec`. Throws Error in
  /// these cases: `spec` does not have exactly one tool, `touch` does not have one entry for each
  /// phase of the schedule, `target` or the input is missing, or a limit is out of range.
  std::unique_ptr<MpcTask> operator()(const MpcSpec& spec) const;
};

}  // namespace burnish
