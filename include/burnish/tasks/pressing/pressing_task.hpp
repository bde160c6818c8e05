// What a task that presses a tool on a surface tells an MpcController: when contact is made, which
// forces and ways are too much, and what is aimed at.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "burnish/mpc/surface_estimate.hpp"

namespace burnish {

/// Phases of a tool that comes to a surface, presses on it, follows a path there and leaves, as
/// Command::phase and traces count them. Home comes first where there is one: see HomeSpec.
enum class Phase { Reach, Approach, Ramp, Track, Retreat, Home };

constexpr int number_of(Phase phase) { return static_cast<int>(phase); }
/// "reach", "approach", "ramp", "track", "retreat" or "home".
std::string name_of(Phase phase);
const std::vector<std::string>& phase_names();  ///< of all, by number

/// What the tool has to do with the surface in a phase.
/// @described pressing
enum class Touch {
  Free,     ///< nothing touches: a force is a fault, and what is felt is the sensor's noise
  Due,      ///< contact is to be made: SchedulePhase.until "contact"
  Wanted,   ///< pressed
  Leaving,  ///< pressed at first; free once the tool has come off, or `release` s are over
};

/// When a run is given up for what happens at the tool. Infinite: never.
/// @described pressing
struct ToolLimits {
  /// [N] at the tool, mean over force_window, > 0 or infinite @more A rigid impact's force at a
  /// single instant is its impulse over the sampling time and says little.
  double force = 100.0;
  double force_window = 5e-3;  ///< [s], >= 0 @more rounded to ticks, one at least
  double tool_speed = 1.0;     ///< [m/s], > 0 or infinite
  double contact_lost = 0.15;  ///< [s] without force while it is wanted, > 0 or infinite
  /// [m] that the tool may go on after contact was due, > 0 or infinite @more Along the normal,
  /// from when the schedule's clock began to wait for it (SchedulePhase::hold before it was due):
  /// how far the surface may lie behind where it is thought to be.
  double late_contact_travel = 0.03;
  /// [s] that contact may come late, > 0 or infinite @more from the same moment
  double late_contact_time = 3.0;
  /// [N] while moving through free space, > 0 or infinite @more Mean over `force_window`, where
  /// nothing is to touch, and while leaving once the tool has come off (its force fell below the
  /// threshold of contact) or `release` s are over. More where noise reaches further: six
  /// deviations of that mean.
  double unexpected_force = 15.0;
  /// [s] into the retreat after which it is free space at the latest, > 0 or infinite
  double release = 0.5;
};

/// What plans keep, as hard constraints. Infinite: not kept.
/// @described pressing
struct PlanLimits {
  double joint_margin = 0.0;  ///< [rad (m)] that joints keep from their limits, >= 0 or infinite
  double joint_speed = 1.0;   ///< of the robot's velocity limits, > 0 or infinite
  /// of the robot's effort limits; nor is more than that sent, > 0 or infinite
  double torque = 1.0;
  /// [N] that the force may be off its target while pressing; it is never below zero, > 0 or
  /// infinite
  double force_band = std::numeric_limits<double>::infinity();
  /// [1/s], of the robot's effort limits: rate of change of torques, with a torque_cutoff, > 0 or
  /// infinite
  double joint_torque_rate = std::numeric_limits<double>::infinity();
};

/// What the task asks of the tool at a time of the schedule, for the record. What the controller
/// aims at is what the costs of the problem say.
/// @described pressing
/// Friction in plans goes with its force.
struct TaskTarget {
  /// [m]; in the axes of MpcSpec::base where there is one
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();
  /// [N], along the normal; 0: no contact wanted, and no friction is reckoned with
  double force = 0.0;
};

/// The surface that a round tip presses on, as the task believes it to be.
/// @described pressing
/// In the axes of MpcSpec::base where there is one, else of the world.
struct PressedSurface {
  SurfaceShape shape = {};
  Eigen::Vector3d point_world = Eigen::Vector3d::Zero();    ///< [m], of it
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< there, of any length, not zero
  double tip_radius = 0.02;                                 ///< [m], > 0
  SurfaceEstimateOptions estimate = {};
};

/// The task of an MpcSpec. Its event is "contact": a measured normal force above the threshold and
/// the sensor's noise, which is found out while nothing touches.
/// @described pressing
/// Put into MpcSpec::task. Where the noise comes near the threshold, it is the mean over 5 ms that
/// counts, against six of its own deviations. Its faults are SpeedLimit, UnexpectedContact,
/// NoContact, ContactLate, ForceLimit and ContactLost.
struct PressingTask {
  std::vector<Touch> touch = {};  ///< one for each phase of the schedule
  /// by time of the schedule, each tick; must be given
  std::function<TaskTarget(double time)> target = {};
  ToolLimits limits = {};
  /// What contacts that follow a surface follow, from the start as believed and while the tool
  /// slides as estimated. None: references and normal are the specification's.
  std::optional<PressedSurface> surface = {};

  /// Throws Error for entries of touch that the schedule has no phases for, or the reverse, for no
  /// target, and for limits out of range.
  std::unique_ptr<MpcTask> operator()(const MpcSpec& spec) const;
};

}  // namespace burnish
