// Random robots, states and contacts for contact tests.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "base/decomposition.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "support/robots.hpp"

namespace burnish::test {

inline Model robot(const std::string& name) { return named_robot(name); }

struct RobotState {
  Eigen::VectorXd q, v, tau;
};

inline Eigen::VectorXd uniform(int n, double bound, std::mt19937_64& generator) {
  Eigen::VectorXd x(n);
  for (double& entry : x)
    entry = bound * (2.0 * static_cast<double>(generator() >> 11) * 0x1.0p-53 - 1.0);
  return x;
}

inline RobotState random_state(const Model& model, std::mt19937_64& generator) {
  const Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd v = uniform(model.nv, 1.0, generator);
  return {q, v, uniform(model.nv, 10.0, generator)};
}

/// Smallest eigenvalue of J M^-1 J^T, scaled to a unit diagonal, at the last state.
inline double independence(const ContactDynamics& dynamics) {
  if (dynamics.rows() == 0) return 1.0;
  const Eigen::MatrixXd J = dynamics.jacobian();
  const Eigen::MatrixXd G = J * solve_positive(dynamics.mass_matrix(), J.transpose());
  const Eigen::VectorXd scale = G.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd unit = scale.asDiagonal() * G * scale.asDiagonal();
  const double smallest = symmetric_eigen(unit).values[0];
  return std::isfinite(smallest) ? smallest : 0.0;
}

/// Returns a random state at which the contacts are far from redundant. Throws Error if 2000
/// attempts find none.
inline RobotState regular_state(const Model& model, ContactDynamics& dynamics,
                                std::mt19937_64& generator, double min_independence = 1e-3) {
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const RobotState state = random_state(model, generator);
    dynamics.acceleration(state.q, state.v, state.v);
    if (independence(dynamics) > min_independence) return state;
  }
  throw Error("no posture of " + model.name + " has independent contacts");
}

/// Returns v without the component that moves the contacts.
inline Eigen::VectorXd at_rest(ContactDynamics& dynamics, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& v) {
  dynamics.acceleration(q, v, v);
  const Eigen::MatrixXd J = dynamics.jacobian();
  return v - least_squares(J, J * v);
}

inline Eigen::Matrix3d tilt() {
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

/// The four references, with a tilted surface, and local axes that are rotated in the tool.
inline std::vector<Reference> all_references() {
  return {Reference::local(), Reference::centered(), Reference::surface(tilt()), Reference::world(),
          Reference::local(tilt())};
}

/// References of contacts: all_references() and a reference that follows a surface.
inline std::vector<Reference> contact_references() {
  std::vector<Reference> result = all_references();
  const Eigen::Vector3d near(0.3, 0.0, 0.2);
  result.push_back(Reference::on(Quadric::osculating(near, tilt(), 0.5, 0.2, -0.8), near));
  return result;
}

/// all_references(), and references whose origin or axes move with a body other than tool and base.
inline std::vector<Reference> all_references(const Model& model, const std::string& tool,
                                             const std::string& base) {
  std::vector<Reference> result = all_references();
  const std::string third = far_frame(model, {tool, base});
  result.push_back({Anchor::Tool, third, tilt()});
  result.push_back({third, Anchor::Base, tilt()});
  result.push_back({Anchor::Base, third, tilt()});
  result.push_back({Anchor::World, Anchor::Tool, tilt()});
  return result;
}

inline ContactSpec contact(const std::string& tool, const std::string& base = "world",
                           const Reference& reference = Reference::centered(),
                           const Directions& directions = Directions::all(),
                           Acceleration acceleration = Acceleration::TimeDerivative) {
  ContactSpec spec;
  spec.name = tool;
  spec.tool = tool;
  spec.base = base;
  spec.reference = reference;
  spec.directions = directions;
  spec.acceleration = acceleration;
  return spec;
}

/// Largest difference, relative to the largest entry of `want` (at least `floor`).
inline double relative_error(const Eigen::Ref<const Eigen::MatrixXd>& got,
                             const Eigen::Ref<const Eigen::MatrixXd>& want, double floor = 1e-9) {
  if (got.rows() != want.rows() || got.cols() != want.cols()) return 1e300;
  if (want.size() == 0) return 0.0;
  const double error = (got - want).cwiseAbs().maxCoeff();
  return std::isfinite(error) ? error / std::max(want.cwiseAbs().maxCoeff(), floor) : 1e300;
}

}  // namespace burnish::test
