// The task as an optimal control problem over time.
#pragma once

#include <map>
#include <string>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/polishing/task.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"

namespace burnish::polishing {

/// A task with everything resolved: robot, start, surface, path in the world, phases.
/// @described polishing
/// Of a surface that the robot carries (Task::surface_frame) what is in the world is in the axes of
/// that frame.
struct Setting {
  Robot robot;                   ///< @required
  Eigen::VectorXd q_start;       ///< nq @required
  SceneSpec scene;               ///< as the controller knows it @required
  Eigen::Matrix3d surface_axes;  ///< columns: two tangents and the normal, world @required
  Eigen::Vector3d p_start;       ///< of the tool, m, world @required
  Eigen::Vector3d p_center;  ///< of the tool at the path's origin in contact, m, world @required
  double reach_end = 0.0;    ///< [s] of the schedule
  double touch = 0.0;        ///< [s] of the schedule
  double ramp_end = 0.0;     ///< [s] of the schedule
  double track_end = 0.0;    ///< [s] of the schedule
  /// kg m^2 (kg) by joint, that Task.assume_rotors added to the robot's armature
  std::map<std::string, double> assumed_rotors = {};
  std::optional<HomeMove> home = {};  ///< from where a run begins (Task.home) to q_start
};

/// The task's robot. Of a URDF file, which has no settings, only the joints that carry the tool
/// move: the others are held at zero. Throws Error as load_robot() does.
Robot load_task_robot(const Task& task);
/// Whether the start is found by find_posture() rather than taken from the robot's settings.
bool searches_posture(const Task& task, const Robot& robot);

/// Throws Error for a task that does not fit together, a base that floats free, and for a posture
/// that is to be searched (find_posture()) where there is none.
Setting make_setting(const Task& task);
/// The same for a robot at hand, whatever the task says of it.
Setting make_setting(const Task& task, const Robot& robot);
/// The same for a robot at hand and a starting posture, nq entries, whatever the task says of both.
Setting make_setting(const Task& task, const Robot& robot, const Eigen::VectorXd& q_start);

/// Where the tool shall be and how hard it shall press, at a time of the schedule.
TaskPoint task_point(const Task& task, const Setting& setting, const Path& path, double time);

/// Where the tip's centre is while the tip touches at a point of the path, as seen along the normal
/// at the path's origin: place, velocity, acceleration and the surface's normal.
TaskPoint point_on(const Task& task, const Setting& setting, const PlanarPoint& point);

/// Gains that the task does not state are fitted to the arm, see fit_gains().
/// Without a preview of the force (ForceProfile::preview) plans take it from a clock that
/// controllers made of one specification share: make a specification for each.
MpcSpec make_mpc(const Task& task, const Setting& setting);
/// What controllers without a plan cannot do, a sentence: stand, or press on what the robot carries
/// itself; empty: they can try.
std::string wants_plans(const Task& task);
/// What controllers without a plan are told of the task. They have no reach: from their start they
/// go down to the surface.
PressingPath pressing_path(const Task& task, const Setting& setting);
/// The baseline on the same task.
ImpedanceSpec make_baseline(const Task& task, const Setting& setting);
/// The admittance controller on the same task.
AdmittanceSpec make_admittance(const Task& task, const Setting& setting);

}  // namespace burnish::polishing
