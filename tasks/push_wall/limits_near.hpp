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

/// Returns the names of at most three hard constraints that the plan reaches to within a thousandth
/// of their scale, such as "torque limits/arm_left_4_joint, pressure of ...". Constraints that are
/// reached at the most knots come first.
std::string limits_near(const ProblemSpec& spec, const PlanAt& plan);

}  // namespace burnish::push_wall
