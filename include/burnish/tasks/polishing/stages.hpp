// The polishing task as specifications of its controllers: optimal control problem and schedule.
#pragma once

#include <map>
#include <string>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/polishing/task.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"

namespace burnish::polishing {

/// Task with all settings filled in: robot, start, surface, path in the world, phases.
/// @described polishing
/// If the robot carries the surface, positions and axes are in the frame Task::surface_frame
/// instead of the world.
struct Setting {
  Robot robot;              ///< Robot of the task @required
  Eigen::VectorXd q_start;  ///< Configuration at the start, nq @required
  SceneSpec scene;          ///< Tip, surface and feet as the controller assumes them @required
  /// Axes of the surface in the world; the columns are two tangents and the normal
  /// @required
  Eigen::Matrix3d surface_axes;
  Eigen::Vector3d p_start;  ///< Position of the tool at the start, in the world [m] @required
  /// Position of the tool when it touches the surface at the path's origin, in the world [m]
  /// @required
  Eigen::Vector3d p_center;
  double reach_end = 0.0;  ///< Schedule time at the end of the phase Reach [s]
  double touch = 0.0;      ///< Schedule time of the planned contact [s]
  double ramp_end = 0.0;   ///< Schedule time when the ramp ends and the path begins [s]
  double track_end = 0.0;  ///< Schedule time at the end of the path [s]
  /// Rotor inertia that Task.assume_rotors added to joints, by joint name [kg m^2 (kg)]
  std::map<std::string, double> assumed_rotors = {};
  /// Move from Task.home to q_start; none if the run begins at q_start
  std::optional<HomeMove> home = {};
};

/// Loads the robot of the task. If the task names a URDF file, which has no settings, only the
/// joints that carry the tool move. All other joints are then held at zero. Throws Error in the
/// same cases as load_robot().
Robot load_task_robot(const Task& task);
/// Returns true if the starting posture is searched by find_posture(), and false if it comes from
/// the robot's settings.
bool searches_posture(const Task& task, const Robot& robot);

/// Fills in all settings of a task: loads the robot, finds the starting posture, places the
/// surface, and computes the times of the phases. Throws Error for contradictory settings, for a
/// floating base without feet, and if find_posture() finds no posture.
Setting make_setting(const Task& task);
/// Fills in all settings of a task for `robot`, which replaces the robot that the task names.
Setting make_setting(const Task& task, const Robot& robot);
/// Fills in all settings of a task. `robot` replaces the robot that the task names, and `q_start`
/// (nq entries) replaces the starting posture.
Setting make_setting(const Task& task, const Robot& robot, const Eigen::VectorXd& q_start);

/// Returns the target motion and target force of the tool at the schedule time `time` [s].
TaskPoint task_point(const Task& task, const Setting& setting, const Path& path, double time);

/// Returns the motion of the tip's centre while the tip touches the surface at `point` of the path.
/// The result has position, velocity and acceleration of the centre, and the normal of the surface.
/// On a curved surface, `point` is projected along the normal at the path's origin.
TaskPoint point_on(const Task& task, const Setting& setting, const PlanarPoint& point);

/// Returns the specification of the task's model predictive controller. Gains without a value in
/// the task are first chosen by fit_gains(). Throws Error if the start violates
/// constraints.joint_margin.
///
/// If ForceProfile::preview is false, plans read the present time from a clock inside the
/// specification, to find the present target force. All controllers made from one specification
/// share this clock. Therefore make one specification for each controller.
MpcSpec make_mpc(const Task& task, const Setting& setting);
/// Returns the reason why the task needs the model predictive controller, as one sentence: the
/// robot stands on its feet or carries the surface. Returns an empty text if the baseline and
/// admittance controllers can run the task.
std::string wants_plans(const Task& task);
/// Returns the task for the baseline and admittance controllers. These controllers move from the
/// start straight to the surface, without a phase Reach. Throws Error if wants_plans() returns a
/// sentence.
PressingPath pressing_path(const Task& task, const Setting& setting);
/// Returns the specification of the impedance controller (`baseline`) for the task. Throws Error in
/// the same cases as pressing_path().
ImpedanceSpec make_baseline(const Task& task, const Setting& setting);
/// Returns the specification of the admittance controller for the task. Throws Error in the same
/// cases as pressing_path().
AdmittanceSpec make_admittance(const Task& task, const Setting& setting);

}  // namespace burnish::polishing
