// Hand that rests on a plane while the tool polishes: scene, contact, costs, monitors, figures.
#pragma once

#include <vector>

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/stages.hpp"

namespace burnish::polishing {

/// Throws EntryError if the resting hand is inconsistent with the robot or with other keys.
void check_rest(const Task& task, const Model& model);

/// Returns the hand as a support on its plane. In the configuration `q` (nq), the hand indents the
/// plane with the stated force.
TouchSpec resting_support(const RestingHand& rest, const Model& model, const Eigen::VectorXd& q);

/// Returns the supports of a scene that are feet.
std::vector<TouchSpec> feet_in(const Task& task, const SceneSpec& scene);

/// Returns the motor torques (nv) that hold the starting posture against gravity and, with a
/// resting hand, against the force on the hand.
Eigen::VectorXd torque_at_start(const Task& task, const Setting& setting);

/// Throws EntryError if the starting posture cannot hold the force on the resting hand within the
/// torque limits of plans.
void refuse_weak_rest(const Task& task, const Setting& setting);

/// Returns the contact of the hand with its plane. Plans keep the centre of the hand in place.
ContactSpec resting_contact(const Task& task);

/// Adds the contact of the hand, the cost on its force, and its friction cone to a stage. Without a
/// resting hand, the stage stays unchanged.
void keep_resting(const RestingHand& rest, Stage& stage);

/// Adds the resting hand to the supports of a controller, and monitors its force and its slip. The
/// stages and the task of the controller must be set before. Without a resting hand, `mpc` stays
/// unchanged.
void set_resting(const Task& task, MpcSpec& mpc);

/// Returns the statistics of the hand over the rows of a trace between `begin` and `end` [s].
RestFigures rest_figures(const RestingHand& rest, const Setting& setting, const Trace& trace,
                         double begin, double end);

/// Returns why the force of the hand does not pass the verdict; empty if it does. The largest
/// allowed rms error is Verdict::force_rmse times the force of the hand.
std::string rest_failure(const Task& task, const RestFigures& figures);

/// Returns the statistics as a sentence, such as "left_tool rested with 20.1 N on the path, rms
/// error 0.31 N, slip 0.2 mm".
std::string rest_text(const RestingHand& rest, const RestFigures& figures);

}  // namespace burnish::polishing
