// Names of the constraints that are active in a plan.
#pragma once

#include "burnish/mpc/mpc.hpp"

namespace burnish::push_wall {

/// Copy of a plan, with the stage and the time of each knot.
struct PlanAt {
  Eigen::MatrixXd xs, us;     ///< States and controls, one row per knot.
  std::vector<int> stages;    ///< Stage of each knot.
  std::vector<double> times;  ///< Time of each knot on the schedule's clock [s].
  Eigen::VectorXd torque_error;
};
PlanAt plan_now(const MpcController& mpc);

/// Returns the names of hard constraints that the plan reaches to within a thousandth of their
/// scale, such as "torque limits/arm_left_4_joint, pressure of ...". At most three names, sorted by
/// the number of knots at which the constraint is reached.
std::string limits_near(const ProblemSpec& spec, const PlanAt& plan);

}  // namespace burnish::push_wall
