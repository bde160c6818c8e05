// Loads the robot of a pressing task and selects the starting posture.
#pragma once

#include <functional>
#include <string>

#include "burnish/robots/robot.hpp"
#include "sim/light_joints.hpp"

namespace burnish::pressing {

/// Loads a robot. If `robot` is a URDF file, which has no settings, only the joints that carry the
/// tool move; all other joints are locked at zero. With `stands`, all joints and the base move.
/// Throws EntryError for "robot" if load_robot() fails, and for "tool.frame" if the robot does not
/// have the frame.
Robot load_arm(const std::string& robot, const std::string& tool, bool stands = false);

/// Returns "'x' does not exist on robot 'y'" with the nearest name of a frame. If no name is near,
/// the text lists the end links and the first frames or sites that the robot's files define.
/// `of_tool`: true to put frames whose names suggest a tool at the start of the list.
std::string none_of(const Model& model, const std::string& frame, bool of_tool = false);

/// Loads a robot with a floating base, even if its files fix the base. The joints `locked` are
/// locked. Throws EntryError for "robot" if load_robot() fails.
Robot load_floating(const std::string& robot, const std::vector<std::string>& locked = {});

/// Throws EntryError for "robot" if the base is floating.
void refuse_floating_base(const Model& model);

/// Returns the posture named `posture` (nq), or the default posture if the name is empty. Calls
/// `search` in two cases: for the name searched_posture, and for an empty name if the robot has no
/// default posture. Throws EntryError for "posture" if the name is unknown or the search fails.
Eigen::VectorXd start_posture(const Robot& robot, const std::string& posture,
                              const std::function<Eigen::VectorXd()>& search);

/// Throws EntryError for "tool.axis" if the angle between the pressing direction `axis` and the
/// inward normal `-normal` exceeds `max_angle` [rad]. Both are unit vectors in one set of axes.
void check_tool_axis(const Eigen::Vector3d& axis, const Eigen::Vector3d& normal, double max_angle);

/// Adds an armature of 2 ms * effort limit / velocity limit to each light joint (light_joints())
/// that has both limits. Returns the added armature by joint [kg m^2 (kg)].
std::map<std::string, double> assume_rotors(Model& model, const Eigen::VectorXd& q,
                                            const Disturbances& disturbances,
                                            const LightJointOptions& options);

/// Returns the named postures of the robot, as starting points of a search.
std::vector<Eigen::VectorXd> known_postures(const Robot& robot);

}  // namespace burnish::pressing
