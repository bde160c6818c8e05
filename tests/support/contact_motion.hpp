// Energy of a robot, and its motion with contacts.
#pragma once

#include <functional>

#include "burnish/dynamics/placement.hpp"
#include "support/contact_states.hpp"
#include "support/trees.hpp"

namespace burnish::test {

/// Returns the kinetic and potential energy [J].
inline double energy_of(const Model& model, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  ContactDynamics dynamics(model);
  dynamics.acceleration(q, v, v);
  double energy = 0.5 * v.dot(dynamics.mass_matrix() * v);
  const std::vector<Eigen::Isometry3d> bodies = testing::body_placements(model, q);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    energy -= model.joints[i].mass * model.gravity.dot(bodies[i] * model.joints[i].com);
  return energy;
}

using Torque = std::function<Eigen::VectorXd(const Eigen::VectorXd& q, const Eigen::VectorXd& v)>;

inline Torque constant_torque(const Eigen::VectorXd& tau) {
  return [tau](const Eigen::VectorXd&, const Eigen::VectorXd&) { return tau; };
}

/// Integrates one step of length h by the classical fourth-order Runge-Kutta method. Only valid for
/// joints whose increments add up: not for a floating base.
inline void runge_kutta_step(ContactDynamics& dynamics, const Model& model, const Torque& torque,
                             double h, RobotState& state) {
  const Eigen::VectorXd q = state.q, v = state.v;
  const auto acceleration = [&](const Eigen::VectorXd& dq, const Eigen::VectorXd& at_v) {
    const Eigen::VectorXd at_q = integrate(model, q, dq);
    dynamics.forward(at_q, at_v, torque(at_q, at_v));
    return Eigen::VectorXd(dynamics.a());
  };
  const Eigen::VectorXd v1 = v, a1 = acceleration(Eigen::VectorXd::Zero(model.nv), v1);
  const Eigen::VectorXd v2 = v + 0.5 * h * a1, a2 = acceleration(0.5 * h * v1, v2);
  const Eigen::VectorXd v3 = v + 0.5 * h * a2, a3 = acceleration(0.5 * h * v2, v3);
  const Eigen::VectorXd v4 = v + h * a3, a4 = acceleration(h * v3, v4);
  state.q = normalized(model, integrate(model, q, h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4)));
  state.v = v + h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

}  // namespace burnish::test
