// The task of pressing at a point while the rest of the arm moves aside: force and point are held,
// and the posture goes elsewhere in the null space.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "burnish/base/trace.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish::press_hold {

/// All that a task file may say, with its defaults.
struct Task {
  std::string robot = "arm7";
  std::string posture = {};  ///< of the robot's settings, where it starts; empty: its default
  std::string tool = "tool";
  double tip_radius = 0.02;                                 ///< m
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< out of the surface, which lies ...
  double clearance = 0.01;                                  ///< ... m under the tip at the start
  double force = 20.0;                                      ///< N
  double touch_force = 5.0;                                 ///< N, at once where contact is made
  /// By joints' names: rad (m) that the posture's reference goes from where it starts.
  std::map<std::string, double> aside = {};

  double approach_speed = 0.03;   ///< m/s
  double ramp_duration = 0.5;     ///< s, from touch_force to force
  double aside_duration = 2.0;    ///< s that the posture takes to go aside
  double hold_duration = 1.0;     ///< s that it stays there
  double retreat_duration = 0.5;  ///< s, off the surface again
  double slip = 0.01;             ///< m that the tool may be off its point along the surface
  double posture_weight = 1.0;    ///< 1/rad^2, beside 1e4 1/m^2 of the point
  double tick_rate = 1000.0;      ///< Hz, of ticks and plans

  // What the controller does not know.
  double mass_scale = 1.0;      ///< of all masses
  double friction = 0.0;        ///< of the surface
  double surface_height = 0.0;  ///< m that the surface is higher than it thinks
};

/// A file with `task: press_hold`. Keys that it does not state keep their defaults;
/// tasks/press_hold/arm7.yaml states all. Throws Error naming file, line, key and what was wanted.
Task read_task(const std::filesystem::path& file);
Task parse_task(const std::string& text, const std::string& name);
/// Such a file with every key; reads back as it was.
std::string task_text(const Task& task);

/// The task with everything resolved.
struct Setting {
  Robot robot;
  Eigen::VectorXd q_start, q_aside;  ///< nq; where the posture's reference begins and ends
  SceneSpec scene;                   ///< as the controller knows it
  Eigen::Matrix3d surface_axes;      ///< columns: two tangents and the normal, world
  Eigen::Vector3d p_hold;            ///< of the tool in contact, m, world
  double touch = 0.0, ramp_end = 0.0, hold_end = 0.0;  ///< s of the schedule
};
/// Throws Error for a robot, posture, tool or joint that there is not.
Setting make_setting(const Task& task);
MpcSpec make_mpc(const Task& task, const Setting& setting);

struct RunResult {
  Setting setting;
  Trace trace;  ///< see ClosedLoop
  Status plant_status = Status::Ok;
  FaultReport fault;
  std::optional<Metrics> metrics;  ///< from 0.2 s after the ramp to the end of the hold
  double moved = 0.0;  ///< rad (m), the largest way of a joint from the ramp's end to the hold's
  double slip = 0.0;   ///< m, farthest that the tool was off its point meanwhile, along the surface
  bool done = false;   ///< to the end without fault
  std::string outcome;  ///< one sentence
};
/// Runs the task in simulated time. `progress` is called now and then with the simulated time and
/// about when it will be over (s); returning false stops the run. Throws Error for a task that does
/// not fit together and a plant that is not there.
RunResult run_task(const Task& task, PlantKind kind,
                   const std::function<bool(double time, double end)>& progress = nullptr);

/// Of the schedule, as the numbers of a trace: approach, ramp, aside, hold, retreat.
const std::vector<std::string>& phase_names();

}  // namespace burnish::press_hold
