// Projection of postures and velocities onto the closed loops of a robot.
#include <algorithm>
#include <cmath>
#include <random>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/model/state.hpp"
#include "contact/descriptions.gen.hpp"
#include "contact/loop_rows.hpp"
#include "model/loops.hpp"
#include "model/posture.hpp"

namespace burnish {
namespace {

/// Returns the diagonal of W^-1/2 for the cost weights W, with zeros at joints that must not move.
Eigen::VectorXd mobility(const Model& model, const std::vector<std::string>& keep,
                         const Eigen::VectorXd& weights) {
  Eigen::VectorXd result = Eigen::VectorXd::Ones(model.nv);
  if (weights.size() != 0) {
    if (weights.size() != model.nv)
      throw Error("projection onto loops: there are " + std::to_string(weights.size()) +
                  " weights; wanted " + std::to_string(model.nv));
    if (!weights.allFinite() || !(weights.minCoeff() > 0.0))
      throw Error("projection onto loops: a weight is " + number(weights.minCoeff()) +
                  "; wanted positive finite numbers");
    result = weights.cwiseSqrt().cwiseInverse();
  }
  for (const std::string& name : keep) {
    const Joint& joint = model.joints[to_size(model.joint_index(name))];
    // Followers have the v_index of their leader.
    result.segment(joint.v_index, std::max(joint.nv, 1)).setZero();
  }
  return result;
}

/// Damped Gauss-Newton search for a posture that closes the loops.
class Descent {
 public:
  Descent(const Model& model, LoopRows& rows, const LoopProjectionOptions& options,
          Eigen::VectorXd mobility)
      : model_(model), rows_(rows), options_(options), mobility_(std::move(mobility)) {}

  /// Sets the ranges of joints: their limits, extended to `q` if a joint starts beyond a limit.
  void set_range(const Eigen::VectorXd& q) {
    lower_ = model_.q_lower.cwiseMin(q);
    upper_ = model_.q_upper.cwiseMax(q);
  }

  /// Searches from `q` until the loops are closed, no step reduces the error, or `iterations`
  /// reaches its maximum. Returns the posture found, and adds the number of its steps to
  /// `iterations`.
  Eigen::VectorXd from(Eigen::VectorXd q, int& iterations) {
    q = within_range(q);
    rows_.update(q);
    double damping = 1e-12;
    while (!closed() && iterations < options_.max_iterations) {
      ++iterations;
      const Eigen::VectorXd error = rows_.error();
      const Eigen::MatrixXd J = rows_.jacobian() * movable(q, error).asDiagonal();
      const double scale = J.squaredNorm();
      bool better = false;
      for (int tries = 0; tries < 12 && !better && scale > 0.0; ++tries) {
        const Eigen::VectorXd damped = Eigen::VectorXd::Constant(J.rows(), damping * scale);
        const Eigen::VectorXd step =
            -(mobility_.array() * damped_step(J, damped, error).array()).matrix();
        const Eigen::VectorXd trial = within_range(integrate(model_, q, shortened(step)));
        rows_.update(trial);
        better = rows_.error().allFinite() && rows_.error().norm() < error.norm();
        damping = better ? std::max(0.1 * damping, 1e-12) : std::max(10.0 * damping, 1e-6);
        if (better) q = trial;
      }
      if (!better) {
        rows_.update(q);
        break;
      }
    }
    return q;
  }

  bool closed() const { return !(rows_.error().cwiseAbs().maxCoeff() > options_.tolerance); }

 private:
  static bool is_limited(const Joint& joint) {
    return joint.kind == JointKind::Revolute || joint.kind == JointKind::Prismatic;
  }

  /// Scales the step to at most 1 rad or 1 m per joint. Linearization is poor for larger steps.
  static Eigen::VectorXd shortened(const Eigen::VectorXd& step) {
    return step / std::max(1.0, step.cwiseAbs().maxCoeff());
  }

  /// Returns `mobility_` with additional zeros at joints that would move beyond their limit.
  Eigen::VectorXd movable(const Eigen::VectorXd& q, const Eigen::VectorXd& error) const {
    Eigen::VectorXd result = mobility_;
    if (!options_.within_limits) return result;
    const Eigen::VectorXd down = rows_.jacobian().transpose() * error;
    for (const Joint& joint : model_.joints) {
      if (joint.follows || !is_limited(joint)) continue;
      const double at = q[joint.q_index], push = -down[joint.v_index];
      const bool stopped = (at >= upper_[joint.q_index] && push > 0.0) ||
                           (at <= lower_[joint.q_index] && push < 0.0);
      if (stopped) result[joint.v_index] = 0.0;
    }
    return result;
  }

  Eigen::VectorXd within_range(Eigen::VectorXd q) const {
    if (!options_.within_limits) return q;
    for (const Joint& joint : model_.joints) {
      if (joint.follows || !is_limited(joint)) continue;
      const int k = joint.q_index;
      q[k] = std::clamp(q[k], lower_[k], upper_[k]);
    }
    return q;
  }

  const Model& model_;
  LoopRows& rows_;
  const LoopProjectionOptions& options_;
  Eigen::VectorXd mobility_, lower_, upper_;
};

/// Returns the closure error of each loop at the configuration of the last rows.update().
std::vector<LoopMiss> misses_of(const Model& model, const LoopRows& rows) {
  std::vector<LoopMiss> misses;
  int row = 0;
  for (const Loop& loop : model.loops) {
    LoopMiss miss{loop.name};
    for (int d = 0; d < 6; ++d) {
      if (!loop.directions.has(d)) continue;
      double& sum = d < 3 ? miss.translation : miss.rotation;
      sum = std::hypot(sum, rows.error()[row++]);
    }
    misses.push_back(miss);
  }
  return misses;
}

void check(const LoopProjectionOptions& options) {
  check_ranges(description_of(&options), &options,
               [](const std::string& entry) { return "projection onto loops: " + entry; });
}

}  // namespace

LoopProjection project_onto_loops(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                  const LoopProjectionOptions& options) {
  check_configuration(model, q);
  check(options);
  LoopProjection result;
  result.q = q;
  const Eigen::VectorXd moves = mobility(model, options.keep, options.weights);
  if (model.loops.empty()) return result;
  LoopRows rows(model);
  Descent descent(model, rows, options, moves);
  descent.set_range(q);
  // At a dead point the gradient of the error vanishes, so later attempts start beside q.
  constexpr int attempts = 6;
  constexpr double spread = 0.1;  // attempt i: within i * spread of q; chosen by hand [rad, m]
  std::mt19937_64 generator(20260102);
  double smallest_error = std::numeric_limits<double>::infinity();
  Eigen::VectorXd best = q;
  for (int i = 0; i < attempts && result.iterations < options.max_iterations; ++i) {
    Eigen::VectorXd offset(model.nv);
    for (double& x : offset)
      x = i * spread * (2.0 * static_cast<double>(generator() >> 11) * 0x1.0p-53 - 1.0);
    const Eigen::VectorXd start =
        integrate(model, q, (moves.array() > 0.0).select(offset, 0.0).matrix());
    const Eigen::VectorXd found =
        descent.from(i == 0 ? Eigen::VectorXd(q) : start, result.iterations);
    const double error = rows.error().norm();
    if (error < smallest_error) {
      smallest_error = error;
      best = found;
    }
    if (descent.closed()) break;
  }
  rows.update(best);
  result.q = best;
  result.misses = misses_of(model, rows);
  if (!descent.closed()) result.status = Status::NotConverged;
  return result;
}

std::string LoopProjection::explanation() const {
  if (status == Status::Ok) return "";
  const LoopMiss* worst = nullptr;
  for (const LoopMiss& miss : misses)
    if (worst == nullptr || miss.translation + miss.rotation > worst->translation + worst->rotation)
      worst = &miss;
  if (worst == nullptr) return "";
  return "loop " + in_quotes(worst->loop) + " cannot be closed from the given posture: a gap of " +
         LoopDistance{worst->translation, worst->rotation}.text() + " remains";
}

std::vector<LoopMiss> loop_misses(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q) {
  check_configuration(model, q);
  if (model.loops.empty()) return {};
  LoopRows rows(model);
  rows.update(q);
  return misses_of(model, rows);
}

Eigen::VectorXd project_velocity_onto_loops(const Model& model,
                                            const Eigen::Ref<const Eigen::VectorXd>& q,
                                            const Eigen::Ref<const Eigen::VectorXd>& v,
                                            LoopMetric metric,
                                            const std::vector<std::string>& keep) {
  check_configuration(model, q);
  check_tangent(model, v);
  if (metric == LoopMetric::Mass && !keep.empty())
    throw Error(
        "projection of a velocity onto loops: 'keep' does not work with the mass metric; wanted "
        "the plain metric");
  const Eigen::VectorXd moves = mobility(model, keep, {});
  if (model.loops.empty()) return v;
  LoopRows rows(model);
  rows.update(q);
  const Eigen::MatrixXd& J = rows.jacobian();
  const Eigen::VectorXd nu = J * v;
  if (metric == LoopMetric::Plain) {
    const Eigen::MatrixXd J_moving = J * moves.asDiagonal();
    Eigen::VectorXd result = v - least_squares(J_moving, nu);
    // All joints correct the error that remains after the joints outside `keep` have moved.
    if (!keep.empty()) result -= least_squares(J, J * result);
    return result;
  }
  const Eigen::MatrixXd M = rows.mass_matrix();
  const Eigen::MatrixXd Y = solve_positive_half(M, J.transpose());  // Y^T Y = J M^-1 J^T
  if (!Y.allFinite())
    throw Error(
        "projection of a velocity onto loops: the mass matrix is singular; wanted mass on each "
        "joint, or the plain metric");
  const Eigen::VectorXd impulse = least_squares(Y, least_squares(Y.transpose(), nu));
  return v - solve_positive(M, J.transpose() * impulse);
}

Eigen::VectorXd closed_configuration(const Model& model, const Posture& posture,
                                     const std::vector<std::string>& keep) {
  const Eigen::VectorXd q = configuration(model, posture);
  if (model.loops.empty()) return q;
  LoopProjectionOptions options;
  for (const Joint& joint : model.joints)
    if (std::find(keep.begin(), keep.end(), joint.name) != keep.end())
      options.keep.push_back(joint.name);
  LoopProjection found = project_onto_loops(model, q, options);
  if (found.status != Status::Ok) found = project_onto_loops(model, q);
  if (found.status == Status::Ok) return found.q;
  throw Error("robot " + in_quotes(model.name) + ": " + found.explanation());
}

Eigen::VectorXd closed_configuration(const Model& model, const Posture& posture) {
  std::vector<std::string> keep;
  for (const auto& [name, values] : posture) keep.push_back(name);
  return closed_configuration(model, posture, keep);
}

}  // namespace burnish
