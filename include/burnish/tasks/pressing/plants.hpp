// Plants by name, and the result of a run in closed loop.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "burnish/base/trace.hpp"
#include "burnish/mpc/fault.hpp"
#include "burnish/report/plan_record.hpp"
#include "burnish/report/standing_figures.hpp"
#include "burnish/sim/plant.hpp"

namespace burnish {

/// Kind of plant. A plant simulates a robot and the contacts of the robot.
/// @described pressing
enum class PlantKind {
  Mujoco,  ///< MuJoCo, a physics engine that shares no code with this library
  Ideal,   ///< contact dynamics of this library, with a rigid surface
};
std::string name_of(PlantKind kind);  ///< Returns "mujoco" or "ideal".
/// Returns true if this build has PlantKind::Mujoco.
bool has_mujoco();
/// Creates a plant with the simulation step `dt` [s]. Throws Error if this build does not have the
/// plant `kind`, and in the same cases as checked_scene().
std::unique_ptr<Plant> make_plant(PlantKind kind, const Model& model, const SceneSpec& scene,
                                  double dt);
/// Returns the simulation step of a plant for a control period, both in s. The result is the
/// largest step of at most 0.5 ms that divides the period.
double plant_step(double control_period);

/// Callback of a run, called repeatedly with the simulated time and the expected end of the run, in
/// s. If the callback returns false, the run stops.
using RunProgress = std::function<bool(double time, double end)>;

/// Statistics of the time that a controller needs for a tick, as wall-clock time [s]. The first
/// tick does not count.
struct TickTimes {
  int count = 0;  ///< Number of timed ticks; beyond a million ticks, only every nth tick is timed
  double period = 0.0;  ///< Time between two ticks [s]
  /// Median, 99th percentile, maximum and mean of the time of a tick [s]
  double median = 0.0, p99 = 0.0, maximum = 0.0, mean = 0.0;
  int late = 0;  ///< Number of timed ticks that took longer than `period`
};

/// Result that every task returns after a run in closed loop.
struct TaskRun {
  /// Recorded data with one row per plant step. In runs longer than 100 s, only every nth step has
  /// a row. The comment of ClosedLoop lists the columns.
  Trace trace;
  /// Recorded plans
  PlanRecord plans;
  /// Status of the plant
  Status plant_status = Status::Ok;
  FaultReport fault;         ///< Fault that the MPC detected; FaultKind::None if there was none
  bool interrupted = false;  ///< True if the progress callback stopped the run
  /// True if the run reached its end and did what the task requires; if false, `outcome` states the
  /// reason
  bool succeeded = false;
  /// Statistics of the wall-clock times of ticks, without the first tick
  TickTimes ticks;
  double first_tick = 0.0;  ///< Wall-clock time of the first tick [s]
  double wall_time = 0.0;   ///< Wall-clock time of the simulation [s]
  std::string outcome;      ///< Outcome of the run in one sentence
  /// Statistics of load, slip and tilt of a robot that stands on its feet; none for other robots
  std::optional<StandingFigures> standing;
};

}  // namespace burnish
