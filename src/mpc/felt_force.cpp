#include "mpc/felt_force.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mpc/closed_dynamics.hpp"

namespace burnish {
namespace {

constexpr double first_look = 0.1;  // s in which all is taken for model error
constexpr double memory = 0.2;      // s, of what is told in the air

/// Contact made and lost would be what the observer hurries after, or slows down before.
ModelErrorOptions steady(ModelErrorOptions options) {
  options.boost = options.calm = 1.0;
  return options;
}

}  // namespace

FeltForce::FeltForce(const MpcSpec& spec)
    : observer_(spec.problem.model, spec.tool, steady(spec.model_error), supports_of(spec), {},
                spec.base),
      touch_(spec.contact_threshold),
      motion_(RigidBody(spec.problem.model), spec.tool, spec.base) {
  air_ = rest_ = model_error_ = Eigen::VectorXd::Zero(spec.problem.model.nv);
}

void FeltForce::reset() noexcept {
  observer_.reset();
  air_.setZero();
  model_error_.setZero();
  force_.setZero();
  since_ = 0.0;
}

void FeltForce::update(const MeasurementGate& gate, const Eigen::VectorXd& acted,
                       bool free) noexcept {
  const Measurement& m = gate.last();
  const double dt = gate.dt();
  if (observer_.update(m.q, m.v, acted, Eigen::Vector3d::Zero(), dt) > Status::NotConverged) return;
  const Eigen::VectorXd& told = observer_.torque_error();
  if (free && (since_ < first_look || force_.norm() < touch_)) {
    since_ += dt;
    air_ += std::min(1.0, dt / std::clamp(since_, dt + 1e-9, memory)) * (told - air_);
  }
  rest_ = told - air_;
  motion_.update(gate.body());
  const auto J = motion_.jacobian();
  // A direction that no joint feels gets no force.
  Eigen::Matrix3d normal = J * J.transpose();
  normal.diagonal().array() += 1e-6;  // m^2
  force_ = since_ < first_look ? Eigen::Vector3d::Zero()
                               : Eigen::Vector3d(normal.inverse() * (J * rest_));
  model_error_ = told;
  model_error_.noalias() -= J.transpose() * force_;
}

}  // namespace burnish
