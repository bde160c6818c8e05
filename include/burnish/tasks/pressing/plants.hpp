// The plants that a task runs on, by name, and what a run in closed loop leaves.
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

/// What is controlled in a run.
/// @described pressing
enum class PlantKind {
  Mujoco,  ///< an engine that shares no code with this library
  Ideal,   ///< the library's own contact dynamics, a rigid surface
};
std::string name_of(PlantKind kind);  ///< "mujoco" or "ideal"
/// Whether PlantKind::Mujoco is there in this build.
bool has_mujoco();
/// dt: s. Throws Error for a plant that is not there, and as checked_scene() does.
std::unique_ptr<Plant> make_plant(PlantKind kind, const Model& model, const SceneSpec& scene,
                                  double dt);
/// Largest step up to the plants' usual one that control periods are a multiple of, s.
double plant_step(double control_period);

/// Called now and then with the simulated time and about when it will be over, s. Returning false
/// stops the run.
using RunProgress = std::function<bool(double time, double end)>;

/// Wall clock of the controller's ticks after the first, s.
struct TickTimes {
  int count = 0;        ///< ticks that were timed: every nth of more than a million
  double period = 0.0;  ///< s, between two ticks
  double median = 0.0, p99 = 0.0, maximum = 0.0, mean = 0.0;
  int late = 0;  ///< ticks that took longer than a period
};

/// What a run leaves, whatever its task.
struct TaskRun {
  Trace trace;  ///< of every plant step, every nth beyond 100 s; see ClosedLoop
  PlanRecord plans;
  Status plant_status = Status::Ok;
  FaultReport fault;                        ///< of the MPC; FaultKind::None without
  bool interrupted = false;                 ///< by the progress function
  TickTimes ticks;                          ///< after the first, which solves to its end
  double first_tick = 0.0;                  ///< s of wall clock
  double wall_time = 0.0;                   ///< s, of the simulation
  std::string outcome;                      ///< one sentence
  std::optional<StandingFigures> standing;  ///< of a robot that stands
};

}  // namespace burnish
