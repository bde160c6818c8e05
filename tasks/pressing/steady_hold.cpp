#include "pressing/steady_hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/decomposition.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "mpc/part_specs.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::pressing {
namespace {

constexpr int base_entries = 6;
// Cut-off frequency of the velocity filter in the shipped disturbances [rad/s].
constexpr double velocity_cutoff = 100.0 * std::numbers::pi;

/// Returns the stiffness [N/m, Nm/rad] of the ground along the rows of support_jacobian(). A sole
/// stands on its four corners.
Eigen::VectorXd ground_stiffness(const std::vector<TouchSpec>& feet) {
  std::vector<double> rows;
  for (const TouchSpec& foot : feet) {
    const double x = foot.half_x * foot.half_x, y = foot.half_y * foot.half_y;
    const double k = foot.surface.stiffness;
    rows.insert(rows.end(), 3, k);
    if (foot.is_rectangle()) rows.insert(rows.end(), {k * y, k * x, k * (x + y)});
  }
  return Eigen::Map<const Eigen::VectorXd>(rows.data(), static_cast<Eigen::Index>(rows.size()));
}

/// Simulation of a standing robot under the fallback controller, linearized about the start.
class HeldMotion {
 public:
  HeldMotion(const MpcSpec& mpc, const std::vector<TouchSpec>& feet)
      : tick_(mpc.tick_period), step_(plant_step(mpc.tick_period)) {
    const Model& model = mpc.problem.model;
    const Eigen::VectorXd q = mpc.problem.initial_state.head(model.nq);
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
    ContactDynamics robot(model);
    RigidBody body(model);
    if (!is_usable(robot.forward(q, rest, rest)) || !is_usable(body.update(q, rest)))
      throw Error("the starting posture cannot be evaluated");
    const Eigen::MatrixXd M = robot.mass_matrix();
    const Eigen::MatrixXd J = support_jacobian(model, body, feet);
    const Eigen::MatrixXd K = J.transpose() * ground_stiffness(feet).asDiagonal() * J;
    // Ratio of damping to stiffness of the ground [s].
    const double lag = feet.front().surface.damping / feet.front().surface.stiffness;
    // Implicit Euler steps, because the ground is stiff for a light foot.
    const Eigen::MatrixXd A = M + step_ * (lag + step_) * K;
    v_by_v_ = solve_positive(A, M);
    v_by_q_ = -step_ * solve_positive(A, K);
    v_by_torque_ = step_ * solve_positive(A, Eigen::MatrixXd::Identity(model.nv, model.nv));
    find_gains(mpc, q);
  }

  /// Returns whether the motion decays if the gains of the hold are multiplied by `scale`.
  bool is_steady(double scale) const {
    // Averaging window and duration of the simulation [s], chosen by hand.
    constexpr double window = 0.02, end = 0.5;
    const Eigen::Index n = v_by_v_.rows();
    const double keep = std::exp(-velocity_cutoff * tick_);
    const int steps = static_cast<int>(std::lround(tick_ / step_));
    // The motion starts with unit joint velocities of alternating sign.
    Eigen::VectorXd v = Eigen::VectorXd::Zero(n), q = v, last = v, filtered = v, sent = v;
    for (Eigen::Index k = base_entries; k < n; ++k) v[k] = k % 2 == 0 ? 1.0 : -1.0;
    double at_first = 0.0, at_last = 0.0;
    for (double time = 0.0; time < end; time += tick_) {
      const Eigen::VectorXd torque = sent;
      filtered = keep * filtered + (1.0 - keep) * (q - last) / tick_;
      last = q;
      sent = -scale * (stiffness_ * q + damping_ * filtered);
      for (int i = 0; i < steps; ++i) {
        v = v_by_v_ * v + v_by_q_ * q + v_by_torque_ * torque;
        q += step_ * v;
      }
      const double fastest = v.cwiseAbs().maxCoeff();
      if (!std::isfinite(fastest)) return false;
      if (time < window) at_first = std::max(at_first, fastest);
      if (time > end - window) at_last = std::max(at_last, fastest);
    }
    return at_last < at_first;
  }

 private:
  /// Computes the damping matrix of the hold column by column; the stiffness matrix is a multiple
  /// of it.
  void find_gains(const MpcSpec& mpc, const Eigen::VectorXd& q) {
    const Eigen::Index n = v_by_v_.rows();
    std::vector<int> driven;
    for (int k = base_entries; k < n; ++k) driven.push_back(k);
    Holding holding(holding_spec(mpc), driven);
    // Without measured foot wrenches, all feet count as standing.
    const Eigen::Matrix<double, 6, Eigen::Dynamic> none(6, 0);
    Eigen::VectorXd rest(n), moved(n), v = Eigen::VectorXd::Zero(n);
    holding.torque(q, v, true, none, rest);
    damping_ = Eigen::MatrixXd::Zero(n, n);
    for (const int k : driven) {
      v[k] = 1.0;
      holding.torque(q, v, true, none, moved);
      damping_.col(k) = rest - moved;
      v[k] = 0.0;
    }
    stiffness_ = mpc.fallback.stiffness / std::max(mpc.fallback.damping, 1e-9) * damping_;
  }

  double tick_, step_;                             ///< Periods of controller and plant [s].
  Eigen::MatrixXd v_by_v_, v_by_q_, v_by_torque_;  ///< Derivatives of the next velocity.
  Eigen::MatrixXd stiffness_, damping_;            ///< Negative derivatives of the hold's torque.
};

}  // namespace

Fallback steady_fallback(const MpcSpec& mpc, const std::vector<TouchSpec>& feet) {
  // Gain margins, chosen by hand. The second margin is used if no entry of `scales` reaches the
  // first one.
  constexpr std::array margins{2.0, 1.0};
  constexpr std::array scales{1.0, 0.7, 0.5, 0.35};  // factors on gains; robots sag below 0.35
  Fallback fallback = mpc.fallback;
  if (feet.empty() || !mpc.problem.model.loops.empty()) return fallback;
  const HeldMotion motion(mpc, feet);
  for (const double margin : margins)
    for (const double scale : scales) {
      if (!motion.is_steady(margin * scale)) continue;
      fallback.stiffness *= scale;
      fallback.damping *= scale;
      return fallback;
    }
  return fallback;
}

}  // namespace burnish::pressing
