#include "pressing/statics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/to_size.hpp"
#include "burnish/dynamics/reference.hpp"

namespace burnish::pressing {
namespace {

constexpr int octagon = 8;
constexpr double moment_arm = 0.1;  // arm by which moments are scaled to forces [m]
constexpr int base_rows = 6;

/// Returns the fraction of `step` that keeps the vector `at` positive: 0.99 of the fraction at
/// which an entry becomes zero, at most 1.
double step_ratio(const Eigen::VectorXd& at, const Eigen::VectorXd& step) {
  double ratio = 1.0;
  for (Eigen::Index i = 0; i < at.size(); ++i)
    if (step[i] < 0.0) ratio = std::min(ratio, -0.99 * at[i] / step[i]);
  return ratio;
}

}  // namespace

Statics::Statics(const Model& model, const StaticsSpec& spec) : spec_(spec), nv_(model.nv) {
  const RigidBody body(model);
  weight_ = model.total_mass() * model.gravity.norm();
  for (const TouchSpec& foot : spec.feet) feet_.push_back(body.frame(foot.frame));
  for (const std::string& hand : spec.hands) hands_.push_back(body.frame(hand));
  for (int k = base_rows; k < nv_; ++k)
    if (std::isfinite(spec.torque_limit[k])) limited_.push_back(k);
  name_rows(model);
  forces_ = 0;
  for (const TouchSpec& foot : spec.feet) forces_ += foot.is_rectangle() ? 6 : 3;
  if (spec.hand_friction > 0.0) forces_ += 2 * static_cast<int>(hands_.size());
  ++forces_;  // for the force F of each hand
  // The last unknown is a slack variable: the violation that all rows of G share.
  const Eigen::Index unknowns = forces_ + 1;
  const auto rows = static_cast<Eigen::Index>(names_.size());
  force_map_ = RowMatrix::Zero(nv_, forces_);
  A_ = Eigen::MatrixXd::Zero(base_rows, unknowns);
  G_ = Eigen::MatrixXd::Zero(rows, unknowns);
  KKT_ = Eigen::MatrixXd::Zero(unknowns + base_rows, unknowns + base_rows);
  b_ = y_ = Eigen::VectorXd::Zero(base_rows);
  c_ = x_ = dx_ = Eigen::VectorXd::Zero(unknowns);
  h_ = w_ = z_ = dw_ = dz_ = rows_ = Eigen::VectorXd::Zero(rows);
  rhs_ = solution_ = Eigen::VectorXd::Zero(unknowns + base_rows);
  loads_.assign(names_.size(), -1);
  for (RowMatrix* matrix :
       {&at_.jacobian, &at_.velocity_dq, &at_.acceleration_dq, &at_.acceleration_dv})
    matrix->setZero(6, nv_);
  lu_ = Eigen::PartialPivLU<Eigen::MatrixXd>(unknowns + base_rows);
  // Cost of the violation relative to the force, chosen by hand.
  constexpr double violation_cost = 100.0;
  if (!hands_.empty()) c_[forces_ - 1] = -1.0;
  c_[forces_] = violation_cost;
}

/// Sets the names of the rows of G, in the order in which fill() writes them.
void Statics::name_rows(const Model& model) {
  const auto add = [&](int count, const std::string& name) {
    for (int i = 0; i < count; ++i) names_.push_back(name);
  };
  for (const TouchSpec& foot : spec_.feet) {
    add(octagon, "friction of " + foot.frame);
    add(1, "load of " + foot.frame);
    if (foot.is_rectangle()) add(6, "pressure of " + foot.frame);
  }
  if (spec_.hand_friction > 0.0)
    for (const std::string& hand : spec_.hands) add(octagon, "friction of " + hand);
  for (const int k : limited_) add(2, "torque limits/" + model.v_name(k));
  add(2, "force");  // two rows: F <= upper bound, and shared violation >= 0
}

void Statics::fill_cone(Eigen::Index x, Eigen::Index y, Eigen::Index z, double friction,
                        Eigen::Index& row) noexcept {
  for (int side = 0; side < octagon; ++side, ++row) {
    // The friction octagon has corners on the axes x and y.
    const double angle = (side + 0.5) * 2.0 * M_PI / octagon;
    G_(row, x) = std::cos(angle);
    G_(row, y) = std::sin(angle);
    G_(row, z) = -friction * std::cos(M_PI / octagon);
    loads_[to_size(row)] = z;
  }
}

void Statics::fill_foot(const RigidBody& body, std::size_t foot, Eigen::Index column,
                        Eigen::Index& row) noexcept {
  const TouchSpec& support = spec_.feet[foot];
  const int held = support.is_rectangle() ? 6 : 3;
  body.frame_derivatives(feet_[foot], Reference::centered(), at_);
  // The force on a sole is in the axes of the sole's frame, the force on a point foot in world
  // axes.
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  if (held == 6) R = body.placement(feet_[foot]).linear();
  for (int half = 0; half < held / 3; ++half)  // first the force, then the moment
    for (int i = 0; i < 3; ++i) {
      const double unit = half == 0 ? weight_ : moment_arm * weight_;
      for (int k = 0; k < nv_; ++k) {
        double sum = 0.0;
        for (int j = 0; j < 3; ++j) sum += at_.jacobian(3 * half + j, k) * R(j, i);
        force_map_(k, column + 3 * half + i) = unit * sum;
      }
    }
  fill_cone(column, column + 1, column + 2, support.surface.friction, row);
  G_(row, column + 2) = -1.0;
  h_[row++] = -spec_.min_load / weight_;
  if (held < 6) return;
  const std::array<double, 3> max_arms{
      support.half_y, support.half_x,
      support.surface.friction * std::hypot(support.half_x, support.half_y) / 3.0};
  for (int i = 0; i < 3; ++i)
    for (const double sign : {-1.0, 1.0}) {
      G_(row, column + 3 + i) = sign;
      G_(row, column + 2) = -max_arms[to_size(i)] / moment_arm;
      loads_[to_size(row++)] = column + 2;
    }
}

void Statics::fill(const RigidBody& body) noexcept {
  G_.setZero();
  h_.setZero();
  force_map_.setZero();
  Eigen::Index row = 0, column = 0;
  for (std::size_t foot = 0; foot < feet_.size(); ++foot) {
    fill_foot(body, foot, column, row);
    column += spec_.feet[foot].is_rectangle() ? 6 : 3;
  }
  const Eigen::Index force = forces_ - 1;
  const Eigen::Matrix3d axes = Reference::surface_with_normal(spec_.normal_world).rotation;
  for (const int hand : hands_) {
    body.frame_derivatives(hand, Reference::centered(), at_);
    const bool has_friction = spec_.hand_friction > 0.0;
    for (int k = 0; k < nv_; ++k) {
      const Eigen::Vector3d moves(at_.jacobian(0, k), at_.jacobian(1, k), at_.jacobian(2, k));
      force_map_(k, force) += weight_ * moves.dot(axes.col(2));
      if (!has_friction) continue;
      force_map_(k, column) = weight_ * moves.dot(axes.col(0));
      force_map_(k, column + 1) = weight_ * moves.dot(axes.col(1));
    }
    if (!has_friction) continue;
    fill_cone(column, column + 1, force, spec_.hand_friction, row);
    column += 2;
  }
  const VectorView gravity = body.gravity_torque();
  for (int k = 0; k < base_rows; ++k) {
    for (Eigen::Index j = 0; j < forces_; ++j) A_(k, j) = force_map_(k, j) / weight_;
    b_[k] = gravity[k] / weight_;
  }
  for (const int k : limited_) {  // tau = g - J^T f
    const double limit = spec_.torque_limit[k];
    for (const double sign : {-1.0, 1.0}) {
      for (Eigen::Index j = 0; j < forces_; ++j) G_(row, j) = -sign * force_map_(k, j) / limit;
      h_[row++] = 1.0 - sign * gravity[k] / limit;
    }
  }
  G_.col(forces_).head(row).setConstant(-1.0);
  constexpr double max_weights = 100.0;  // upper bound of F in units of the weight
  G_(row, force) = 1.0;
  h_[row++] = max_weights;
  G_(row++, forces_) = -1.0;
}

bool Statics::step() noexcept {
  const Eigen::Index n = x_.size(), m = w_.size();
  const double mean = w_.dot(z_) / static_cast<double>(m);
  // Centring ratio and regularization of the interior-point step, chosen by hand.
  constexpr double centre = 0.15, damping = 1e-11;
  // Residuals of the rows, and step of the multipliers z without z / w * G dx (added below).
  for (Eigen::Index i = 0; i < m; ++i) rows_[i] = G_.row(i).dot(x_) + w_[i] - h_[i];
  for (Eigen::Index i = 0; i < m; ++i)
    dz_[i] = centre * mean / w_[i] - z_[i] + z_[i] / w_[i] * rows_[i];
  KKT_.setZero();
  for (Eigen::Index i = 0; i < m; ++i) {
    const double d = z_[i] / w_[i];
    for (Eigen::Index a = 0; a < n; ++a) {
      if (G_(i, a) == 0.0) continue;
      for (Eigen::Index b = 0; b <= a; ++b) KKT_(a, b) += d * G_(i, a) * G_(i, b);
    }
  }
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < a; ++b) KKT_(b, a) = KKT_(a, b);
    KKT_(a, a) += damping;
    double sum = -c_[a];
    for (Eigen::Index k = 0; k < base_rows; ++k) {
      KKT_(n + k, a) = KKT_(a, n + k) = A_(k, a);
      sum -= A_(k, a) * y_[k];
    }
    for (Eigen::Index i = 0; i < m; ++i) sum -= G_(i, a) * (z_[i] + dz_[i]);
    rhs_[a] = sum;
  }
  for (Eigen::Index k = 0; k < base_rows; ++k) rhs_[n + k] = b_[k] - A_.row(k).dot(x_);
  lu_.compute(KKT_);
  solution_ = lu_.solve(rhs_);
  if (!solution_.allFinite()) return false;
  for (Eigen::Index a = 0; a < n; ++a) dx_[a] = solution_[a];
  for (Eigen::Index i = 0; i < m; ++i) {
    const double moved = G_.row(i).dot(dx_);
    dw_[i] = -rows_[i] - moved;
    dz_[i] += z_[i] / w_[i] * moved;
  }
  const double primal = step_ratio(w_, dw_), dual = step_ratio(z_, dz_);
  x_ += primal * dx_;
  w_ += primal * dw_;
  y_ += dual * solution_.tail(base_rows);
  z_ += dual * dz_;
  return true;
}

bool Statics::solve() noexcept {
  constexpr int max_iterations = 60;
  constexpr double tolerance = 1e-6;
  x_.setZero();
  y_.setZero();
  w_.setOnes();
  z_.setOnes();
  for (int i = 0; i < max_iterations; ++i) {
    if (!step()) return false;
    if (w_.dot(z_) < tolerance && rows_.cwiseAbs().maxCoeff() < tolerance &&
        rhs_.tail(base_rows).cwiseAbs().maxCoeff() < tolerance)
      return true;
  }
  return false;
}

double Statics::amount(Eigen::Index row) const noexcept {
  const Eigen::Index load = loads_[to_size(row)];
  if (load >= 0) return std::abs(G_(row, load)) * x_[load];
  constexpr double torque = 1.0;  // rows of torques are scaled by their limits
  return names_[to_size(row)].starts_with("load") ? -h_[row] : torque;
}

double Statics::max_force(const RigidBody& body) noexcept {
  fill(body);
  limit_ = static_cast<int>(names_.size()) - 1;
  if (!solve()) return -std::numeric_limits<double>::infinity();
  // Selects the limiting row: an increase of its limit by 1 % raises the force most.
  double max_gain = 0.0;
  for (Eigen::Index row = 0; row + 2 < z_.size(); ++row) {
    const double gain = z_[row] * amount(row);
    if (gain > max_gain) limit_ = static_cast<int>(row);
    max_gain = std::max(max_gain, gain);
  }
  // Largest violation that counts as feasible, in units of the weight.
  constexpr double max_violation = 1e-4;
  if (x_[forces_] > max_violation) return -weight_ * x_[forces_];
  return hands_.empty() ? 0.0 : weight_ * x_[forces_ - 1];
}

}  // namespace burnish::pressing
