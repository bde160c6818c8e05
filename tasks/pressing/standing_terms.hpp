// What standing adds to the stages of a task, to its scene and to its plans.
#pragma once

#include <optional>
#include <vector>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/estimate/base_estimator.hpp"
#include "burnish/estimate/foot_contacts.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Throws EntryError for feet that the robot has not, for feet of a robot whose base is fixed, and
/// for a floating base without feet, naming what the robot has.
void check_standing(const Model& model, const Standing& standing);

/// The feet on the ground where they are at q (nq). Throws EntryError for a sole whose z axis does
/// not point up there.
std::vector<SupportSpec> supports_at(const Model& model, const Standing& standing,
                                     const Eigen::VectorXd& q);

/// A sentence where the stated stiffness is ten times what the weight asks for, or more; else
/// empty. Light feet hammer on such ground, and a plant's step may be too long for it.
std::string ground_note(const Model& model, const Standing& standing);

/// What holds its base at first.
HoistSpec hoist_of(const Model& model, const Standing& standing);

/// Jacobian of what supports hold at the state of `body`, in world axes at their frames: 6 rows of
/// a sole, 3 of a ball.
Eigen::MatrixXd support_jacobian(const Model& model, const RigidBody& body,
                                 const std::vector<SupportSpec>& supports);

/// nv, of which motors and supports bear `needed` (nv: Nm, N) together, the least of both: the
/// motors' part, zero for the base. Without supports all of it.
Eigen::VectorXd torque_on_supports(const Model& model, const RigidBody& body,
                                   const std::vector<SupportSpec>& supports,
                                   const Eigen::VectorXd& needed);

/// Balance and momentum, 1 being the base's orientation: of every stage and the end.
std::vector<CostTerm> standing_costs(const Model& model, const Standing& standing,
                                     const Eigen::VectorXd& q_start);
/// What a controller is told of them: its supports with their sensors, how it holds the robot at
/// first and after a fault.
void set_standing(const Standing& standing, MpcSpec& mpc);

/// What tells where the base is, of a base that is not known.
std::optional<BaseEstimatorOptions> base_estimator(const Standing& standing);

/// When its feet stand. The noise of their sensors is some that is chosen for the robot's weight.
FootContactOptions foot_contact_options(const Model& model);

/// `disturbances` with noise of the sensors in the feet, and of their moments, as sensors of a
/// range for this robot have it: at most 0.022 of a foot's part of the weight, and as much on 0.1
/// m.
Disturbances for_feet(const Model& model, const Standing& standing, Disturbances disturbances);

/// N, of standing.least_load.
double least_load_of(const Model& model, const Standing& standing);

/// Supports with the friction and the soles that plans keep within.
std::vector<SupportSpec> within_plans(std::vector<SupportSpec> feet, const Standing& standing);

/// To a stage, not the end: friction, load and pressure of every foot as limits, and what feet do
/// against each other as a cost. `feet`: of foot_contacts(). A direction that a foot does not hold
/// carries no force, and its terms are left out.
void keep_standing(const Model& model, const Standing& standing,
                   const std::vector<ContactSpec>& feet, Stage& stage);

}  // namespace burnish::pressing
