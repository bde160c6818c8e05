// Benchmark problem for solvers: press with 30 N along z and draw a circle.
#pragma once

#include <cmath>

#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/problem.hpp"
#include "ocp/position_limits.hpp"

namespace burnish::polishing {

/// Returns the problem with `knots` knots of 10 ms and the initial state (q0, 0). The contact holds
/// `frame` at its initial height (world z) and leaves other directions free. The contact uses
/// kp = 0, kd = 50 and the acceleration `Classical`.
inline ProblemSpec reference_problem(const Model& model, const std::string& frame,
                                     const Eigen::VectorXd& q0, int knots) {
  const int nv = model.nv;
  const Eigen::Isometry3d at_q0 = frame_placement(model, q0, frame);
  const Eigen::Vector3d p0 = at_q0.translation();
  const Eigen::Vector4d turned = Eigen::Quaterniond(at_q0.linear()).coeffs();

  ProblemSpec spec{.model = model};
  ContactSpec contact{.name = "surface",
                      .tool = frame,
                      .directions = Directions::z(),
                      .acceleration = Acceleration::Classical,
                      .target = at_q0};
  contact.with_gains(0.0, 50.0);
  spec.contacts = {contact};
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + nv);
  spec.initial_state.head(model.nq) = q0;

  const auto circle = Signal::over_time(3, [p0](double t, Eigen::Ref<Eigen::VectorXd> p) {
    p = p0 + 0.07 * Eigen::Vector3d(std::cos(t) - 1.0, std::sin(t), 0.0);
  });
  std::vector<CostTerm> common{
      {.name = "state", .residual = residual::State{}, .weight = 1e-1},
      {.name = "position", .residual = residual::FramePosition{frame, circle}, .weight = 1e4},
      {.name = "rotation", .residual = residual::FrameRotation{frame, turned}, .weight = 1e1},
  };
  const ocp::PositionLimits limits = ocp::position_limits(model);
  if (limits.lower.size() > 0)
    common.push_back({.name = "position limits",
                      .residual = residual::JointPosition{},
                      .weight = 1e2,
                      .penalty = Penalty::barrier(limits.lower, limits.upper)});
  const int base = model.joints.front().kind == JointKind::FreeFlyer ? 6 : 0;
  if (nv > base) {
    const Eigen::VectorXd max_velocity = 0.1 * model.velocity_limit.tail(nv - base);
    common.push_back({.name = "velocity limits",
                      .residual = residual::JointVelocity{},
                      .weight = 1e2,
                      .penalty = Penalty::barrier(-max_velocity, max_velocity)});
  }
  spec.terminal = common;
  for (CostTerm& term : spec.terminal) term.weight *= 0.1;

  Stage press{.name = "press", .contacts = {"surface"}, .costs = common, .step = 0.01};
  spec.stages = {press};
  spec.horizon = {{"press", knots}};
  const Problem bare(spec);
  const Eigen::VectorXd u0 =
      bare.quasi_static(0, spec.initial_state, Eigen::VectorXd::Constant(1, 30.0)).control;
  spec.stages[0].costs.push_back(
      {.name = "control", .residual = residual::Control{u0}, .weight = 1e-4});
  spec.stages[0].costs.push_back(
      {.name = "force", .residual = residual::ContactForce{"surface", {}, 30.0}, .weight = 1e-2});
  return spec;
}

/// Returns the control with which the robot stays at rest in the initial state and presses with 30
/// N.
inline Eigen::VectorXd static_control(const Problem& problem) {
  return problem
      .quasi_static(0,
                    Eigen::Map<const Eigen::VectorXd>(problem.initial_state(), problem.state().nx),
                    Eigen::VectorXd::Constant(1, 30.0))
      .control;
}

}  // namespace burnish::polishing
