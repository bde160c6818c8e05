#include "estimate/felt_force.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Time constants, chosen by hand.

// Learning time in free air [s]. Until it has passed, the estimated force is zero, and the whole
// observed torque counts as model error.
constexpr double first_look = 0.1;
constexpr double memory = 0.2;  // averaging time in free air [s]

/// Returns the options with a constant observer bandwidth. A variable bandwidth would change when
/// the tool gains or loses contact.
ModelErrorOptions steady(ModelErrorOptions options) {
  options.transient_scale = options.quiescent_scale = 1.0;
  return options;
}

}  // namespace

FeltForce::FeltForce(const Model& model, const ModelErrorOptions& options, const RobotState& state,
                     const std::vector<ContactSpec>& supports, double touch)
    : observer_(model, steady(options), state, supports, {}), touch_(touch) {
  air_ = rest_ = model_error_ = Eigen::VectorXd::Zero(model.nv);
}

void FeltForce::reset() noexcept {
  observer_.reset();
  air_.setZero();
  model_error_.setZero();
  force_.setZero();
  learned_for_ = 0.0;
}

void FeltForce::update(RobotState& state, const Eigen::VectorXd& acted, double dt,
                       bool free) noexcept {
  if (!is_usable(observer_.update(state, acted, no_force_, dt, {}))) return;
  const Eigen::VectorXd& sum = observer_.torque_error();
  if (free && (learned_for_ < first_look || force_.norm() < touch_)) {
    learned_for_ += dt;
    air_ += std::min(1.0, dt / std::clamp(learned_for_, dt + 1e-9, memory)) * (sum - air_);
  }
  rest_ = sum - air_;
  const auto J = state.tools().front().jacobian();
  // With regularization, the force is zero in directions in which no joint moves the tool.
  Eigen::Matrix3d normal = J * J.transpose();
  normal.diagonal().array() += 1e-6;  // regularization [m^2]
  if (learned_for_ < first_look)
    force_.setZero();
  else
    force_.col(0) = Eigen::Vector3d(normal.inverse() * (J * rest_));
  model_error_ = sum;
  model_error_.noalias() -= J.transpose() * force_.col(0);
}

}  // namespace burnish
