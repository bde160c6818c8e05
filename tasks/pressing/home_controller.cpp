#include <algorithm>
#include <cmath>
#include <numeric>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/model/state.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "dynamics/integration.hpp"
#include "pressing/quintic.hpp"
#include "sim/small_product.hpp"

namespace burnish {

double HomeMove::duration() const {
  return std::accumulate(durations.begin(), durations.end(), 0.0);
}

namespace {

// Triple pole of the joint controller [rad/s]. The crossover frequency of the control loop is 60
// rad/s, where a delay of 8 ms costs 30 degrees of phase margin.
constexpr double home_pole = 20.0;
// Largest position error at the end of the move from home [rad (m)], and longest wait until the
// error is below this value [s]. Chosen by hand.
constexpr double home_tolerance = 0.01;
constexpr double max_lateness = 2.0;

class HomeController final : public ControllerWrapper {
 public:
  HomeController(const Model& model, const HomeMove& move, const std::string& tool,
                 const Eigen::Vector3d& normal_world, Controller& then)
      : ControllerWrapper(then),
        move_(move),
        tree_(model),
        body_(model),
        dynamics_(model),
        tool_(body_.frame(tool)),
        q_(move.corners.front()),
        zero_(Eigen::VectorXd::Zero(model.nv)),
        error_(zero_),
        integral_(zero_),
        response_(zero_),
        tau_(zero_),
        step_(zero_),
        effort_limit_(model.effort_limit),
        M_(Eigen::MatrixXd::Zero(model.nv, model.nv)) {
    for (std::size_t i = 0; i + 1 < move.corners.size(); ++i)
      displacements_.push_back(difference(model, move.corners[i], move.corners[i + 1]));
    command_.tools.front().normal_world = normal_world.normalized();
    command_.phase = number_of(Phase::Home);
    command_.tau = zero_;
    reset();
  }

  Status set_payload(std::string_view frame, const InertiaSpec& payload) override {
    const Status status = ControllerWrapper::set_payload(frame, payload);
    return status == Status::Ok ? dynamics_.set_payload(frame, payload) : status;
  }
  void reset() noexcept override {
    ControllerWrapper::reset();
    is_over_ = started_ = false;
    integral_.setZero();
    error_.setZero();
    command_.tau.setZero();
    command_.status = Status::Ok;
  }

  const Command& tick(const Measurement& measurement) noexcept override {
    if (!started_) {
      begin_ = before_ = measurement.time;
      started_ = true;
    }
    const double time = measurement.time - begin_;
    is_over_ = is_over_ || has_ended(time);
    if (is_over_) return ControllerWrapper::tick(measurement);
    command_.status = dynamics_.forward(measurement.q, measurement.v, zero_);
    if (!is_usable(command_.status)) return command_;
    follow(time, measurement);
    before_ = measurement.time;
    return command_;
  }

 private:
  bool has_ended(double time) const noexcept {
    const double end = move_.duration() + move_.settle - 1e-9;
    return time >= end &&
           (error_.lpNorm<Eigen::Infinity>() < home_tolerance || time >= end + max_lateness);
  }

  void follow(double time, const Measurement& measurement) noexcept {
    constexpr double p = home_pole;
    std::size_t leg = 0;
    for (; leg + 1 < displacements_.size() && time >= move_.durations[leg]; ++leg)
      time -= move_.durations[leg];
    const double duration = move_.durations[leg];
    const Eigen::VectorXd& displacement = displacements_[leg];
    const pressing::Quintic at = pressing::quintic(time / duration);
    step_ = at.s * displacement;
    integrate_configuration(tree_, move_.corners[leg].data(), step_.data(), q_.data());
    if (is_usable(body_.update(q_, zero_)))
      command_.tools.front().p_target_world = body_.placement(tool_).translation();
    difference_configuration(tree_, measurement.q.data(), q_.data(), error_.data());
    const double dt = measurement.time - before_;
    for (int i = 0; i < tree_.nv; ++i) {
      // Anti-windup: the integral stops while the motor torque is at its limit.
      const bool is_free = !(std::abs(command_.tau[i]) >= effort_limit_[i]);
      if (is_free) integral_[i] += dt * error_[i];
      response_[i] = at.ds2 / (duration * duration) * displacement[i] + 3.0 * p * p * error_[i] +
                     3.0 * p * (at.ds / duration * displacement[i] - measurement.v[i]) +
                     p * p * p * integral_[i];
    }
    tau_ = dynamics_.bias();
    M_ = dynamics_.mass_matrix();
    add_product(1.0, M_, response_, tau_);
    if (!tau_.allFinite()) {
      command_.status = Status::NotFinite;
      return;
    }
    for (int i = 0; i < tree_.nv; ++i)
      command_.tau[i] = effort_limit_[i] > 0.0
                            ? std::clamp(tau_[i], -effort_limit_[i], effort_limit_[i])
                            : tau_[i];
  }

  HomeMove move_;
  Tree tree_;
  RigidBody body_;
  ContactDynamics dynamics_;
  int tool_;
  Command command_;
  bool started_ = false, is_over_ = false;
  double begin_ = 0.0, before_ = 0.0;  ///< Times of the first and the previous measurement [s].
  std::vector<Eigen::VectorXd> displacements_;  ///< Displacement from each corner to the next (nv).
  Eigen::VectorXd q_;                           ///< Current target posture (nq).
  Eigen::VectorXd zero_, error_, integral_, response_, tau_, step_, effort_limit_;
  Eigen::MatrixXd M_;
};

}  // namespace

std::unique_ptr<Controller> make_home_controller(const Model& model, const HomeMove& move,
                                                 const std::string& tool,
                                                 const Eigen::Vector3d& normal_world,
                                                 Controller& then) {
  if (move.corners.size() < 2 || move.durations.size() + 1 != move.corners.size())
    throw Error("the move has " + std::to_string(move.corners.size()) + " corners and " +
                std::to_string(move.durations.size()) +
                " durations; wanted at least two corners, and one duration for each motion between "
                "two corners");
  for (const Eigen::VectorXd& corner : move.corners) check_configuration(model, corner, "corners");
  return std::make_unique<HomeController>(model, move, tool, normal_world, then);
}

}  // namespace burnish
