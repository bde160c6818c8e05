#include "pressing/stage_terms.hpp"

#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
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

namespace {
/// Returns the scale of constraint rows that are limited to +- `limit`. The scale equals the limit,
/// or 1 for a row without a limit.
Eigen::VectorXd scale_of(const Eigen::VectorXd& limit) {
  return limit.unaryExpr([](double x) { return std::isfinite(x) && x > 0.0 ? x : 1.0; });
}
/// Returns the vector `entries` (nv) without the entries of a floating base, which come first.
Eigen::VectorXd of_joints(const Model& model, const Eigen::VectorXd& entries) {
  const Joint& first = model.joints.front();
  return first.kind == JointKind::FreeFlyer ? Eigen::VectorXd(entries.tail(model.nv - first.nv))
                                            : entries;
}
void check_start(const Model& model, double margin, const Eigen::VectorXd& q) {
  constexpr double rounding = 1e-9;
  for (const Joint& joint : model.joints) {
    if (!ocp::has_position_limit(model, joint)) continue;
    const int k = joint.q_index;
    const double distance = std::min(q[k] - model.q_lower[k], model.q_upper[k] - q[k]);
    if (distance < margin - rounding)
      throw EntryError("constraints.joint_margin",
                       "joint " + in_quotes(joint.name) + " starts " + number(std::abs(distance)) +
                           (distance < 0.0 ? " beyond its limit" : " from its limit") +
                           "; wanted a distance of at least " + number(margin) +
                           ": another start posture, a smaller margin, or joint_margin: never");
  }
}
}  // namespace

std::vector<Constraint> joint_limits(const Model& model, const PlanLimits& limits,
                                     const Eigen::VectorXd& q_start) {
  if (std::isfinite(limits.joint_margin)) check_start(model, limits.joint_margin, q_start);
  std::vector<Constraint> rows;
  const ocp::PositionLimits range = ocp::position_limits(model);
  if (std::isfinite(limits.joint_margin) && range.lower.size() > 0)
    rows.push_back({.name = "joint range",
                    .residual = residual::JointPosition{},
                    .lower = range.lower.array() + limits.joint_margin,
                    .upper = range.upper.array() - limits.joint_margin,
                    .scale = scale_of(0.5 * (range.upper - range.lower))});
  const Eigen::VectorXd fastest = of_joints(model, limits.joint_speed * model.velocity_limit);
  if (std::isfinite(limits.joint_speed) && std::isfinite(fastest.minCoeff()))
    rows.push_back({.name = "joint speed",
                    .residual = residual::JointVelocity{},
                    .lower = -fastest,
                    .upper = fastest,
                    .scale = scale_of(fastest)});
  return rows;
}

Eigen::VectorXd torque_limit(const Model& model, const PlanLimits& limits) {
  return std::isfinite(limits.torque) ? Eigen::VectorXd(limits.torque * model.effort_limit)
                                      : model.effort_limit;
}

std::vector<Constraint> torque_limits(const Model& model, const PlanLimits& limits) {
  const Eigen::VectorXd max_torque = of_joints(model, limits.torque * model.effort_limit);
  if (!std::isfinite(limits.torque) || !std::isfinite(max_torque.minCoeff())) return {};
  return {{.name = "torque limits",
           .residual = residual::Control{},
           .lower = -max_torque,
           .upper = max_torque,
           .scale = scale_of(max_torque)}};
}

std::vector<Constraint> torque_rate_limits(const Model& model, const PlanLimits& limits,
                                           double cutoff) {
  if (!std::isfinite(limits.joint_torque_rate)) return {};
  if (!(cutoff > 0.0))
    throw EntryError("constraints.joint_torque_rate",
                     "a limit of torque rates requires torques in the state of plans; wanted "
                     "controller.torque_cutoff above 0, such as the cut-off of the motors, or "
                     "joint_torque_rate: never");
  const Eigen::VectorXd max_rate = of_joints(model, limits.joint_torque_rate * model.effort_limit);
  if (!std::isfinite(max_rate.minCoeff())) return {};
  return {{.name = "torque rates",
           .residual = residual::JointTorqueRate{},
           .lower = -max_rate,
           .upper = max_rate,
           .scale = scale_of(max_rate)}};
}

Constraint force_limit(const Signal& force, double min_force, double scale,
                       const PlanLimits& limits) {
  Constraint row{.name = "force band",
                 .residual = residual::ContactForce{"surface", {}, force},
                 .lower = Eigen::VectorXd::Constant(1, -std::min(limits.force_band, min_force)),
                 .upper = Eigen::VectorXd::Constant(1, limits.force_band),
                 .scale = Eigen::VectorXd::Constant(1, scale)};
  if (std::isfinite(limits.force_band)) return row;
  row.name = "no pull";
  row.residual = residual::ContactForce{"surface"};
  row.lower.setZero();
  return row;
}

CostTerm torque_cost(const Eigen::VectorXd& rest, double weight) {
  return {.name = "torque", .residual = residual::Control{rest}, .weight = weight};
}

CostTerm place_cost(const std::string& name, const std::string& tool, const Signal& position,
                    const Reference& on_surface, double weight, double normal_weight) {
  return {.name = name,
          .residual = residual::FramePosition{tool, position, on_surface},
          .weight = weight,
          .weights = Eigen::Vector3d(1.0, 1.0, normal_weight)};
}

CostTerm normal_speed_cost(const std::string& name, const std::string& tool, const Signal& target,
                           const Reference& on_surface, double weight) {
  return {.name = name,
          .residual = residual::FrameVelocity{tool, on_surface, target},
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
