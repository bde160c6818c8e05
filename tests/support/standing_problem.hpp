// Whole-body problem for comparisons of solvers: two feet on the ground, the center of mass swings
// sideways.
#pragma once

#include <cmath>
#include <numbers>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/problem.hpp"

namespace burnish::test {

/// Two 6D contacts in Centered axes at the frames `soles`, at their positions at q0, with gains (0,
/// 50).
inline ProblemSpec standing_problem(const Model& model, const std::vector<std::string>& soles,
                                    const Eigen::VectorXd& q0, int knots) {
  const int nv = model.nv;
  ProblemSpec spec;
  spec.model = model;
  Stage stand{.name = "stand", .step = 0.01};
  for (const std::string& sole : soles) {
    ContactSpec contact{.name = sole,
                        .tool = sole,
                        .acceleration = Acceleration::Spatial,
                        .target = frame_placement(model, q0, sole)};
    contact.with_gains(0.0, 50.0);
    spec.contacts.push_back(contact);
    stand.contacts.push_back(sole);
  }
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + nv);
  spec.initial_state.head(model.nq) = q0;
  RigidBody body(model);
  if (body.update(q0, Eigen::VectorXd::Zero(nv)) != Status::Ok)
    throw Error("q0 is not a valid configuration");
  const Eigen::Vector3d c0 = body.com();
  const auto sway = Signal::over_time(3, [c0](double t, Eigen::Ref<Eigen::VectorXd> c) {
    c = c0 + Eigen::Vector3d(0.0, 0.03 * std::sin(std::numbers::pi * t), 0.0);
  });
  Eigen::VectorXd rows = Eigen::VectorXd::Ones(2 * nv);
  rows.head<3>().setZero();
  stand.costs = {
      {.name = "state", .residual = residual::State{}, .weight = 0.1, .weights = rows},
      {.name = "center of mass", .residual = residual::CenterOfMass{sway}, .weight = 1e3}};
  spec.terminal = stand.costs;
  for (CostTerm& term : spec.terminal) term.weight *= 0.1;
  spec.stages = {stand};
  spec.horizon = {{"stand", knots}};
  const Eigen::VectorXd u0 = Problem(spec).quasi_static(0, spec.initial_state).control;
  spec.stages[0].costs.push_back(
      {.name = "control", .residual = residual::Control{u0}, .weight = 1e-3});
  return spec;
}

}  // namespace burnish::test
