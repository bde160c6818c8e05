// Which limits a plan is at.
#pragma once

#include "burnish/mpc/mpc.hpp"

namespace burnish::push_wall {

/// A plan as it was at some time of the schedule.
struct PlanAt {
  Eigen::MatrixXd xs, us;     ///< a row per knot
  std::vector<int> stages;    ///< per knot
  std::vector<double> times;  ///< s of the schedule, per knot
  Eigen::VectorXd torque_error;
};
PlanAt plan_now(const MpcController& mpc);

/// Names of the hard limits that the plan is at, to within a thousandth of their scale, those of
/// most knots first and three at most: "torque limits/arm_left_4_joint, pressure of ...".
std::string limits_near(const ProblemSpec& spec, const PlanAt& plan);

}  // namespace burnish::push_wall
