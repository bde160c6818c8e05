#include "burnish/tasks/pressing/impedance_controller.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "base/sentence.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "dynamics/integration.hpp"
#include "pressing/contact_detector.hpp"
#include "pressing/descriptions.hpp"
#include "sim/small_product.hpp"

namespace burnish {
namespace {

constexpr double slow = 1e-3;  // m/s: friction is fed forward in full above this speed of the path
constexpr double longest_lag = 0.03;   // m
constexpr double touch_window = 5e-3;  // s, of the mean that tells contact from noise

ImpedanceSpec checked(const Model& model, ImpedanceSpec spec) {
  const auto refuse = [](const std::string& what) {
    throw Error("the impedance controller's " + what);
  };
  check_ranges(description_of(&spec), &spec,
               [](const std::string& entry) { return "the impedance controller's " + entry; });
  if (!spec.task) refuse("task is empty; wanted a function of time");
  if (spec.posture.size() != model.nq)
    refuse("posture has " + std::to_string(spec.posture.size()) + " entries; wanted " +
           std::to_string(model.nq));
  spec.normal_world.normalize();
  return spec;
}

/// 0 to 1 over unit time, at rest at both ends.
double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

class ImpedanceController final : public Controller {
 public:
  ImpedanceController(const Model& model, const ImpedanceSpec& spec);

  int nv() const override { return tree_.nv; }
  void reset() noexcept override;
  const Command& tick(const Measurement& measurement) noexcept override;

 private:
  TaskPoint update_phase(const Measurement& measurement);
  Status update_model(const Measurement& measurement);
  Eigen::Vector3d acceleration(const TaskPoint& target);
  Eigen::Vector3d tool_force(const TaskPoint& target);
  void add_posture(const Measurement& measurement);

  ImpedanceSpec spec_;
  Tree tree_;
  RigidBody body_;
  ContactDynamics dynamics_;
  int tool_;
  ContactDetector touch_;
  FrameDerivatives motion_;
  Command command_;
  Phase phase_ = Phase::Approach;
  double since_ = 0.0;     ///< s in the phase
  double integral_ = 0.0;  ///< N
  double measured_ = 0.0;  ///< N, along the normal
  double lag_ = 0.0;       ///< m, of the tip behind the approaching point
  Eigen::VectorXd zero_, tau_, posture_torque_, response_, error_;
  Eigen::MatrixXd M_, J_, inverse_M_Jt_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::LLT<Eigen::Matrix3d> inertia_;  ///< of J M^-1 J^T
};

ImpedanceController::ImpedanceController(const Model& model, const ImpedanceSpec& spec)
    : spec_(checked(model, spec)),
      tree_(model),
      body_(model),
      dynamics_(model),
      tool_(body_.frame(spec.tool)),
      touch_(spec.contact_threshold, static_cast<int>(std::lround(touch_window / spec.period))),
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
  since_ = integral_ = measured_ = lag_ = 0.0;
  touch_.reset();
  command_.tau.setZero();
  phase_ = Phase::Approach;
  command_.phase = number_of(phase_);
  command_.normal_world = spec_.normal_world;
  command_.status = Status::Ok;
}

const Command& ImpedanceController::tick(const Measurement& measurement) noexcept {
  command_.status = update_model(measurement);
  if (command_.status > Status::NotConverged) return command_;
  const TaskPoint target = update_phase(measurement);
  const Eigen::Vector3d force = tool_force(target);
  tau_ = dynamics_.bias();
  add_product(1.0, J_.transpose(), force, tau_);
  add_posture(measurement);
  if (tau_.allFinite())
    command_.tau = tau_;
  else
    command_.status = Status::NotFinite;
  return command_;
}

Status ImpedanceController::update_model(const Measurement& measurement) {
  Status status = body_.update(measurement.q, measurement.v);
  if (status > Status::NotConverged) return status;
  if (!measurement.tool_force_world.allFinite()) return Status::NotFinite;
  status = dynamics_.forward(measurement.q, measurement.v, zero_);
  if (status > Status::NotConverged) return status;
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

/// Moves on to the next phase where its time has come; what is aimed at now.
TaskPoint ImpedanceController::update_phase(const Measurement& measurement) {
  measured_ = measurement.tool_force_world.dot(command_.normal_world);
  const Phase before = phase_;
  touch_.add(measured_, phase_ == Phase::Approach);
  if (phase_ == Phase::Approach && touch_.touches()) phase_ = Phase::Ramp;
  if (phase_ == Phase::Ramp && since_ >= spec_.ramp) phase_ = Phase::Track;
  command_.phase = number_of(phase_);
  since_ = phase_ == before ? since_ + spec_.period : 0.0;
  TaskPoint target = spec_.task(phase_ == Phase::Track ? since_ : 0.0);
  if (phase_ == Phase::Approach) target.force = 0.0;
  if (phase_ == Phase::Ramp)
    target.force = spec_.contact_threshold +
                   (target.force - spec_.contact_threshold) * smooth(since_ / spec_.ramp);
  if (phase_ != Phase::Track) target.v_world.setZero(), target.a_world.setZero();
  command_.target_force = target.force;
  command_.normal_world =
      target.normal_world.isZero(0.0) ? spec_.normal_world : target.normal_world;
  command_.p_target_world = target.p_world;
  command_.force_estimate_world = measurement.tool_force_world;
  return target;
}

/// Wanted of the tip, m/s^2. On the approach a point runs ahead of the tip and draws it along, so
/// that joint friction delays the contact but does not prevent it.
Eigen::Vector3d ImpedanceController::acceleration(const TaskPoint& target) {
  const Eigen::Vector3d& n = command_.normal_world;
  const Eigen::Vector3d v = body_.velocity(tool_, Reference::centered()).head<3>();
  const Eigen::Vector3d error = target.p_world - body_.placement(tool_).translation();
  const Eigen::Vector3d wanted =
      target.a_world + spec_.kp * error + spec_.kd * (target.v_world - v);
  double normal = -spec_.kd_normal * n.dot(v);
  if (phase_ == Phase::Approach) {
    const double slower = -spec_.approach_speed - n.dot(v);
    lag_ = std::clamp(lag_ + spec_.period * slower, -longest_lag, longest_lag);
    normal = spec_.kd_normal * slower + spec_.kp * lag_;
  }
  return wanted + (normal - n.dot(wanted)) * n;
}

/// What the tool shall exert, N, world axes.
Eigen::Vector3d ImpedanceController::tool_force(const TaskPoint& target) {
  // Without joint accelerations, the tip's acceleration is dJ/dt v.
  const Eigen::Vector3d drift = body_.acceleration(tool_, Reference::centered()).head<3>();
  Eigen::Vector3d force = inertia_.solve(Eigen::Vector3d(acceleration(target) - drift));
  if (phase_ == Phase::Approach) return force;
  integral_ += spec_.ki * spec_.period * (target.force - measured_);
  integral_ = std::clamp(integral_, -spec_.integral_limit, spec_.integral_limit);
  force -= (target.force + integral_) * command_.normal_world;
  const double speed = target.v_world.norm();
  if (speed > 0.0)
    force += spec_.friction * target.force * std::min(speed / slow, 1.0) / speed * target.v_world;
  return force;
}

void ImpedanceController::add_posture(const Measurement& measurement) {
  difference_configuration(tree_, measurement.q.data(), spec_.posture.data(), error_.data());
  for (int i = 0; i < tree_.nv; ++i)
    response_[i] = spec_.posture_kp * error_[i] - spec_.posture_kd * measurement.v[i];
  // M response in the null space: M response - J^T L J response.
  multiply(M_, response_, posture_torque_);
  Eigen::Vector3d felt;
  multiply(J_, response_, felt);
  inertia_.solveInPlace(felt);
  tau_ += posture_torque_;
  add_product(-1.0, J_.transpose(), felt, tau_);
}

}  // namespace

std::unique_ptr<Controller> make_impedance_controller(const Model& model,
                                                      const ImpedanceSpec& spec) {
  return std::make_unique<ImpedanceController>(model, spec);
}

}  // namespace burnish
