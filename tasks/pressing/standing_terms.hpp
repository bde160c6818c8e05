// Parts of a task that depend on standing: stages, scene, plans, estimation of the base.
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

/// Throws EntryError in three cases: a foot does not exist on the robot, a robot with a fixed base
/// has feet, or a floating base has no feet.
void check_standing(const Model& model, const Standing& standing);

/// Returns the feet as supports on the ground, at their positions for `q` (nq). Throws EntryError
/// for a sole whose z axis does not point up.
std::vector<TouchSpec> supports_at(const Model& model, const Standing& standing,
                                   const Eigen::VectorXd& q);

/// Returns a warning if the stated ground stiffness is at least ten times the automatic one, else
/// an empty string. On such ground light feet bounce, and the step of the plant may be too long.
std::string ground_note(const Model& model, const Standing& standing);

/// Returns the hoist that holds the base at the start.
HoistSpec hoist_of(const Model& model, const Standing& standing);

/// Returns the Jacobian of the directions that supports hold, at the state of `body`: 6 rows per
/// sole, 3 rows per point foot. Rows are in world axes, at the frames of the supports.
Eigen::MatrixXd support_jacobian(const Model& model, const RigidBody& body,
                                 const std::vector<TouchSpec>& supports);

/// Returns motor torques (nv, zero for the base) that, together with forces of the supports,
/// produce the generalized forces `needed` (nv) [Nm, N]. The result is the least-squares solution
/// of smallest norm. Without supports, returns `needed`.
Eigen::VectorXd torque_on_supports(const Model& model, const RigidBody& body,
                                   const std::vector<TouchSpec>& supports,
                                   const Eigen::VectorXd& needed);

/// Returns costs on balance and momentum, for every stage and the end of the horizon.
std::vector<CostTerm> standing_costs(const Model& model, const Standing& standing,
                                     const Eigen::VectorXd& q_start);
/// Sets the parts of a controller that depend on standing: supports, sensors of the supports,
/// settling time, slip response and fallback gains.
void set_standing(const Standing& standing, MpcSpec& mpc);

/// Returns options of the base estimator; nothing if the base is measured or fixed.
std::optional<BaseEstimatorOptions> base_estimator(const Standing& standing);

/// Returns options of the contact detection of feet. The assumed noise of the force sensors is at
/// most a fraction of the robot's weight.
FootContactOptions foot_contact_options(const Model& model);

/// Returns `disturbances` with limited noise of the foot sensors. Force noise is at most 0.022 of
/// the weight per foot; moment noise is at most this force times 0.1 m. The limit represents
/// sensors of smaller range on light robots.
Disturbances for_feet(const Model& model, const Standing& standing, Disturbances disturbances);

/// Returns the smallest load of each foot in plans: standing.min_load or its automatic value [N].
double min_load_of(const Model& model, const Standing& standing);

/// Returns `feet` with the friction and the sole sizes that plans assume.
std::vector<TouchSpec> within_plans(std::vector<TouchSpec> feet, const Standing& standing);

/// Adds terms for every foot to a stage: constraints on friction, load and pressure, and costs on
/// internal forces between the feet. Terms for a direction that a foot does not hold are left out.
/// The stage must not be the end of the horizon. `feet`: result of foot_contacts().
void keep_standing(const Model& model, const Standing& standing,
                   const std::vector<ContactSpec>& feet, Stage& stage);

}  // namespace burnish::pressing
