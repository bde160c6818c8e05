// The arm of a task that presses: loaded, and the posture that it starts from.
#pragma once

#include <functional>
#include <string>

#include "burnish/robots/robot.hpp"
#include "sim/light_joints.hpp"

namespace burnish::pressing {

/// Of a URDF file, which has no settings, only the joints that carry the tool move: the others are
/// held at zero. One that stands moves all of them, and its base. Throws EntryError: "robot" as
/// load_robot() refuses it, "tool.frame" for a frame that the robot has not.
Robot load_arm(const std::string& robot, const std::string& tool, bool stands = false);

/// "'x' is none of robot 'y'", with the nearest known name of a frame or, where none is near, with
/// those that its files add, sites among them, and the links at its ends, of many the first.
/// `of_tool`: after frames whose names look like those of tools.
std::string none_of(const Model& model, const std::string& frame, bool of_tool = false);

/// With a base that floats, whatever its files say of it, and these joints locked. Throws
/// EntryError, "robot", as load_robot() refuses it.
Robot load_floating(const std::string& robot, const std::vector<std::string>& locked = {});

/// Throws EntryError, "robot", where the base floats free.
void refuse_floating_base(const Model& model);

/// nq: the posture of that name; of the robot's default if it is empty; what `search` finds for
/// searched_posture, and where the robot has no default. Throws EntryError, "posture".
Eigen::VectorXd start_posture(const Robot& robot, const std::string& posture,
                              const std::function<Eigen::VectorXd()>& search);

/// Throws EntryError, "tool.axis", where the direction that a tool presses in is more than `most`
/// [rad] off the way into a surface, against its normal. Both in the same axes, of length one.
void check_tool_axis(const Eigen::Vector3d& axis, const Eigen::Vector3d& normal, double most);

/// Adds an armature of 2 ms * effort / velocity to each light joint of the model (light_joints())
/// whose effort and speed are limited; what was added, by joint [kg m^2 (kg)].
std::map<std::string, double> assume_rotors(Model& model, const Eigen::VectorXd& q,
                                            const Disturbances& disturbances,
                                            const LightJointOptions& options);

/// Of the robot's named postures, to search from.
std::vector<Eigen::VectorXd> known_postures(const Robot& robot);

}  // namespace burnish::pressing
