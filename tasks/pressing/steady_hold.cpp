#include "pressing/steady_hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/decomposition.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "mpc/holding.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::pressing {
namespace {

constexpr int base_entries = 6;
constexpr double velocity_cutoff = 100.0 * std::numbers::pi;  // rad/s, of the shipped disturbances

/// Stiffness [N/m, Nm/rad] of the ground along the rows of support_jacobian(). A sole stands on its
/// four corners.
Eigen::VectorXd ground_stiffness(const std::vector<SupportSpec>& feet) {
  std::vector<double> rows;
  for (const SupportSpec& foot : feet) {
    const double x = foot.half_x * foot.half_x, y = foot.half_y * foot.half_y;
    rows.insert(rows.end(), 3, foot.stiffness);
    if (foot.is_sole())
      rows.insert(rows.end(), {foot.stiffness * y, foot.stiffness * x, foot.stiffness * (x + y)});
  }
  return Eigen::Map<const Eigen::VectorXd>(rows.data(), static_cast<Eigen::Index>(rows.size()));
}

/// The robot on its feet about its start, and what holds it, step by step.
class HeldMotion {
 public:
  HeldMotion(const MpcSpec& mpc, const std::vector<SupportSpec>& feet)
      : tick_(mpc.tick_period), step_(plant_step(mpc.tick_period)) {
    const Model& model = mpc.problem.model;
    const Eigen::VectorXd q = mpc.problem.initial_state.head(model.nq);
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
    ContactDynamics robot(model);
    RigidBody body(model);
    if (robot.forward(q, rest, rest) > Status::NotConverged ||
        body.update(q, rest) > Status::NotConverged)
      throw Error("the starting posture cannot be evaluated");
    const Eigen::MatrixXd M = robot.mass_matrix();
    const Eigen::MatrixXd J = support_jacobian(model, body, feet);
    const Eigen::MatrixXd K = J.transpose() * ground_stiffness(feet).asDiagonal() * J;
    const double lag = feet.front().damping / feet.front().stiffness;  // s
    // Implicit, as ground that is stiff for a light foot asks for.
    const Eigen::MatrixXd A = M + step_ * (lag + step_) * K;
    keeps_ = solve_positive(A, M);
    sinks_ = -step_ * solve_positive(A, K);
    moves_ = step_ * solve_positive(A, Eigen::MatrixXd::Identity(model.nv, model.nv));
    learn_hold(mpc, q);
  }

  /// Whether the motion dies away with `part` of the hold's gains.
  bool is_steady(double part) const {
    constexpr double begun = 0.02, end = 0.5;  // s
    const Eigen::Index n = keeps_.rows();
    const double keep = std::exp(-velocity_cutoff * tick_);
    const int steps = static_cast<int>(std::lround(tick_ / step_));
    // Every joint is moved a little, in turns.
    Eigen::VectorXd v = Eigen::VectorXd::Zero(n), q = v, last = v, filtered = v, sent = v;
    for (Eigen::Index k = base_entries; k < n; ++k) v[k] = k % 2 == 0 ? 1.0 : -1.0;
    double at_first = 0.0, at_last = 0.0;
    for (double time = 0.0; time < end; time += tick_) {
      const Eigen::VectorXd acts = sent;
      filtered = keep * filtered + (1.0 - keep) * (q - last) / tick_;
      last = q;
      sent = -part * (stiffens_ * q + damps_ * filtered);
      for (int i = 0; i < steps; ++i) {
        v = keeps_ * v + sinks_ * q + moves_ * acts;
        q += step_ * v;
      }
      const double fastest = v.cwiseAbs().maxCoeff();
      if (!std::isfinite(fastest)) return false;
      if (time < begun) at_first = std::max(at_first, fastest);
      if (time > end - begun) at_last = std::max(at_last, fastest);
    }
    return at_last < at_first;
  }

 private:
  /// The hold's torques by the joints' speeds, of which those by their places are a multiple.
  void learn_hold(const MpcSpec& mpc, const Eigen::VectorXd& q) {
    const Eigen::Index n = keeps_.rows();
    std::vector<int> driven;
    for (int k = base_entries; k < n; ++k) driven.push_back(k);
    Holding holding(mpc, driven);
    const Eigen::Matrix<double, 6, Eigen::Dynamic> none(6, 0);  // sensors: what stands, stands
    Eigen::VectorXd rest(n), moved(n), v = Eigen::VectorXd::Zero(n);
    holding.torque(q, v, true, none, rest);
    damps_ = Eigen::MatrixXd::Zero(n, n);
    for (const int k : driven) {
      v[k] = 1.0;
      holding.torque(q, v, true, none, moved);
      damps_.col(k) = rest - moved;
      v[k] = 0.0;
    }
    stiffens_ = mpc.fallback.stiffness / std::max(mpc.fallback.damping, 1e-9) * damps_;
  }

  double tick_, step_;                     ///< s
  Eigen::MatrixXd keeps_, sinks_, moves_;  ///< next v by v, q and torque
  Eigen::MatrixXd stiffens_, damps_;       ///< torque by q and v
};

}  // namespace

Fallback steady_fallback(const MpcSpec& mpc, const std::vector<SupportSpec>& feet) {
  // Times the gains, that has to be steady; the second where nothing has the first.
  constexpr std::array margins{2.0, 1.0};
  constexpr std::array parts{1.0, 0.7, 0.5, 0.35};  // with less, a robot sags into its knees
  Fallback fallback = mpc.fallback;
  if (feet.empty() || !mpc.problem.model.loops.empty()) return fallback;
  const HeldMotion motion(mpc, feet);
  for (const double margin : margins)
    for (const double part : parts) {
      if (!motion.is_steady(margin * part)) continue;
      fallback.stiffness *= part;
      fallback.damping *= part;
      return fallback;
    }
  return fallback;
}

}  // namespace burnish::pressing
