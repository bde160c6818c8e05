#include "burnish/tasks/pressing/impedance_controller.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "dynamics/integration.hpp"
#include "pressing/descriptions.gen.hpp"
#include "pressing/path_follower.hpp"
#include "sim/small_product.hpp"

namespace burnish {
namespace {

// Path speed above which the full friction force is fed forward [m/s]. Chosen by hand.
constexpr double min_sliding_speed = 1e-3;
// Largest lag of the tip behind the moving set point of the approach [m]. Chosen by hand.
constexpr double max_lag = 0.03;

ImpedanceSpec checked(const Model& model, ImpedanceSpec spec) {
  spec.path = pressing::checked_path(model, spec.path, description_of(&spec), &spec,
                                     "impedance controller");
  return spec;
}

class ImpedanceController final : public Controller {
 public:
  ImpedanceController(const Model& model, const ImpedanceSpec& spec);

  int nv() const override { return tree_.nv; }
  std::optional<std::vector<TouchSensor>> touches() const override {
    return {{{spec_.path.tool, WrenchSensor::Force}}};
  }
  void reset() noexcept override;
  const Command& tick(const Measurement& measurement) noexcept override;

 private:
  Status update_model(const Measurement& measurement);
  void integrate(const TaskPoint& target);
  Eigen::Vector3d acceleration(const TaskPoint& target);
  Eigen::Vector3d tool_force(const TaskPoint& target);
  void add_posture(const Measurement& measurement);

  ImpedanceSpec spec_;
  Tree tree_;
  RigidBody body_;
  ContactDynamics dynamics_;
  int tool_;
  Eigen::Vector3d force_world_ = Eigen::Vector3d::Zero();  ///< Measured force on the tool [N].
  pressing::PathFollower follower_;
  FrameDerivatives motion_;
  Command command_;
  double integral_ = 0.0;  ///< Integral term of the force error [N].
  /// Integral term of the position error along the surface, in world axes [m/s^2].
  Eigen::Vector3d position_integral_;
  bool saturated_ = false;  ///< True if a torque exceeded its limit at the last tick.
  /// Lag of the tip behind the moving set point of the approach [m].
  double lag_ = 0.0;
  Eigen::VectorXd effort_limit_, zero_, tau_, posture_torque_, response_, error_;
  Eigen::MatrixXd M_, J_, inverse_M_Jt_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::LLT<Eigen::Matrix3d> inertia_;  ///< Factorization of J M^-1 J^T, J: tool Jacobian.
};

ImpedanceController::ImpedanceController(const Model& model, const ImpedanceSpec& spec)
    : spec_(checked(model, spec)),
      tree_(model),
      body_(model),
      dynamics_(model),
      tool_(body_.frame(spec.path.tool)),
      follower_(spec_.path),
      effort_limit_(model.effort_limit),
      zero_(Eigen::VectorXd::Zero(model.nv)),
      tau_(zero_),
      posture_torque_(zero_),
      response_(zero_),
      error_(zero_),
      M_(Eigen::MatrixXd::Zero(model.nv, model.nv)),
      J_(Eigen::MatrixXd::Zero(3, model.nv)),
      inverse_M_Jt_(Eigen::MatrixXd::Zero(model.nv, 3)),
      factor_(model.nv) {
  body_.frame_derivatives(tool_, Reference::centered(), motion_);
  command_.tau = zero_;
  reset();
}

void ImpedanceController::reset() noexcept {
  integral_ = lag_ = 0.0;
  position_integral_.setZero();
  saturated_ = false;
  follower_.reset(command_);
}

const Command& ImpedanceController::tick(const Measurement& measurement) noexcept {
  command_.status = update_model(measurement);
  if (!is_usable(command_.status)) return command_;
  const TaskPoint target = follower_.update(force_world_, command_);
  integrate(target);
  const Eigen::Vector3d force = tool_force(target);
  tau_ = dynamics_.bias();
  add_product(1.0, J_.transpose(), force, tau_);
  add_posture(measurement);
  saturated_ = pressing::at_limit(tau_, effort_limit_);
  if (tau_.allFinite())
    command_.tau = tau_;
  else
    command_.status = Status::NotFinite;
  return command_;
}

Status ImpedanceController::update_model(const Measurement& measurement) {
  Status status = body_.update(measurement.q, measurement.v);
  if (!is_usable(status)) return status;
  force_world_ = body_.placement(tool_).linear() * measurement.force_at(0);
  if (!force_world_.allFinite()) return Status::NotFinite;
  status = dynamics_.forward(measurement.q, measurement.v, zero_);
  if (!is_usable(status)) return status;
  body_.frame_derivatives(tool_, Reference::centered(), motion_);
  J_ = motion_.jacobian.topRows(3);
  M_ = dynamics_.mass_matrix();
  inverse_M_Jt_ = J_.transpose();
  factor_.compute(M_);
  factor_.solveInPlace(inverse_M_Jt_);
  Eigen::Matrix3d inverse_inertia;
  multiply(J_, inverse_M_Jt_, inverse_inertia);
  inertia_.compute(inverse_inertia);
  return inertia_.info() == Eigen::Success ? status : Status::SingularContacts;
}

/// Integrates the errors of force and position from the first contact on.
void ImpedanceController::integrate(const TaskPoint& target) {
  if (follower_.phase() == Phase::Approach) return;
  if (follower_.touched()) {
    integral_ = 0.0;
    position_integral_.setZero();
  }
  if (saturated_) return;
  const double dt = spec_.path.period, limit = spec_.gains.position_integral_limit;
  integral_ += spec_.gains.ki * dt * (target.force - follower_.measured());
  integral_ = std::clamp(integral_, -spec_.gains.integral_limit, spec_.gains.integral_limit);
  const Eigen::Vector3d& n = target.normal_world;
  position_integral_ +=
      spec_.gains.ki_position * dt * (target.p_world - body_.placement(tool_).translation());
  position_integral_ -= n.dot(position_integral_) * n;
  if (const double size = position_integral_.norm(); size > limit)
    position_integral_ *= limit / size;
}

/// Returns the desired acceleration of the tip [m/s^2]. During the approach, a critically damped
/// spring pulls the tip towards a set point that moves at the approach speed. Joint friction can
/// therefore delay the contact, but not prevent it.
Eigen::Vector3d ImpedanceController::acceleration(const TaskPoint& target) {
  const Eigen::Vector3d& n = target.normal_world;
  const Eigen::Vector3d v = body_.velocity(tool_, Reference::centered()).head<3>();
  const Eigen::Vector3d error = target.p_world - body_.placement(tool_).translation();
  const ImpedanceGains& gains = spec_.gains;
  const Eigen::Vector3d wanted =
      target.a_world + gains.kp * error + gains.kd * (target.v_world - v) + position_integral_;
  double normal = -gains.kd_normal * n.dot(v);
  if (follower_.phase() == Phase::Approach) {
    const double slower = -spec_.path.approach_speed - n.dot(v);
    lag_ = std::clamp(lag_ + spec_.path.period * slower, -max_lag, max_lag);
    normal = gains.kd_normal * slower + 0.25 * gains.kd_normal * gains.kd_normal * lag_;
  }
  return wanted + (normal - n.dot(wanted)) * n;
}

/// Returns the force at the tool that joint torques must produce, in world axes [N].
Eigen::Vector3d ImpedanceController::tool_force(const TaskPoint& target) {
  // Without joint accelerations, the acceleration of the tip is dJ/dt v.
  const Eigen::Vector3d drift = body_.acceleration(tool_, Reference::centered()).head<3>();
  Eigen::Vector3d force = inertia_.solve(Eigen::Vector3d(acceleration(target) - drift));
  if (follower_.phase() == Phase::Approach) return force;
  force -= (target.force + integral_) * target.normal_world;
  const double speed = target.v_world.norm();
  if (speed > 0.0)
    force += spec_.friction * target.force * std::min(speed / min_sliding_speed, 1.0) / speed *
             target.v_world;
  return force;
}

void ImpedanceController::add_posture(const Measurement& measurement) {
  difference_configuration(tree_, measurement.q.data(), spec_.path.posture.data(), error_.data());
  for (int i = 0; i < tree_.nv; ++i)
    response_[i] = spec_.gains.posture_kp * error_[i] - spec_.gains.posture_kd * measurement.v[i];
  // Adds the torque for accelerations `response_`, projected into the null space of the tool:
  // (M - J^T L J) response_ with L = (J M^-1 J^T)^-1, mass matrix M and tool Jacobian J.
  multiply(M_, response_, posture_torque_);
  Eigen::Vector3d tool_response;
  multiply(J_, response_, tool_response);
  inertia_.solveInPlace(tool_response);
  tau_ += posture_torque_;
  add_product(-1.0, J_.transpose(), tool_response, tau_);
}

}  // namespace

std::unique_ptr<Controller> make_impedance_controller(const Model& model,
                                                      const ImpedanceSpec& spec) {
  return std::make_unique<ImpedanceController>(model, spec);
}

}  // namespace burnish
