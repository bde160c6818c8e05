#include "pressing/stage_terms.hpp"

#include <cmath>

#include "burnish/base/error.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "ocp/position_limits.hpp"

namespace burnish::pressing {

Eigen::VectorXd rest_torque(const Model& model, const Eigen::VectorXd& q) {
  RigidBody body(model);
  if (body.update(q, Eigen::VectorXd::Zero(model.nv)) != Status::Ok)
    throw Error("the starting posture cannot be evaluated");
  return body.gravity_torque();
}

std::vector<CostTerm> joint_limit_costs(const Model& model, double velocity, double position) {
  std::vector<CostTerm> terms{
      {.name = "velocity limits",
       .residual = residual::JointVelocity{},
       .weight = velocity,
       .penalty = Penalty::barrier(-model.velocity_limit, model.velocity_limit)}};
  const ocp::PositionLimits limits = ocp::position_limits(model);
  if (limits.lower.size() > 0)
    terms.push_back(
        {.name = "position limits",
         .residual = residual::JointPosition{},
         .weight = position,
         .penalty = Penalty::barrier(limits.lower.array() + 0.05, limits.upper.array() - 0.05)});
  return terms;
}

std::vector<CostTerm> torque_costs(const Model& model, const Eigen::VectorXd& rest, double torque,
                                   double limits) {
  std::vector<CostTerm> terms{
      {.name = "torque", .residual = residual::Control{rest}, .weight = torque}};
  if (std::isfinite(model.effort_limit.maxCoeff()))
    terms.push_back({.name = "torque limits",
                     .residual = residual::Control{},
                     .weight = limits,
                     .penalty = Penalty::barrier(-model.effort_limit, model.effort_limit)});
  return terms;
}

CostTerm place_cost(const std::string& name, const std::string& tool, const Signal& position,
                    const Eigen::Matrix3d& surface_axes, double weight, double normal_weight) {
  return {.name = name,
          .residual = residual::FramePosition{tool, position, Reference::world(surface_axes)},
          .weight = weight,
          .weights = Eigen::Vector3d(1.0, 1.0, normal_weight)};
}

CostTerm normal_speed_cost(const std::string& name, const std::string& tool, const Signal& target,
                           const Eigen::Matrix3d& surface_axes, double weight) {
  return {.name = name,
          .residual = residual::FrameVelocity{tool, Reference::centered(surface_axes), target},
          .weight = weight,
          .weights = normal_twist(1.0)};
}

Eigen::VectorXd normal_twist(double speed) {
  Eigen::VectorXd twist = Eigen::VectorXd::Zero(6);
  twist[2] = speed;
  return twist;
}

CostTerm force_cost(const Signal& force, double weight) {
  return {
      .name = "force", .residual = residual::ContactForce{"surface", {}, force}, .weight = weight};
}

}  // namespace burnish::pressing
