#include "pressing/bearing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "burnish/dynamics/reference.hpp"

namespace burnish::pressing {
namespace {

constexpr int octagon = 8;
constexpr double moment_arm = 0.1;  // m, of the unit of moments
constexpr int base_rows = 6;

/// A vector's largest step that keeps it positive, of 1 at most and a little less than all.
double room(const Eigen::VectorXd& at, const Eigen::VectorXd& step) {
  double most = 1.0;
  for (Eigen::Index i = 0; i < at.size(); ++i)
    if (step[i] < 0.0) most = std::min(most, -0.99 * at[i] / step[i]);
  return most;
}

}  // namespace

Bearing::Bearing(const Model& model, const BearingSpec& spec) : spec_(spec), nv_(model.nv) {
  const RigidBody body(model);
  weight_ = model.total_mass() * model.gravity.norm();
  for (const SupportSpec& foot : spec.feet) feet_.push_back(body.frame(foot.frame));
  for (const std::string& hand : spec.hands) hands_.push_back(body.frame(hand));
  for (int k = base_rows; k < nv_; ++k)
    if (std::isfinite(spec.torque_limit[k])) limited_.push_back(k);
  name_rows(model);
  forces_ = 0;
  for (const SupportSpec& foot : spec.feet) forces_ += foot.is_sole() ? 6 : 3;
  if (spec.hand_friction > 0.0) forces_ += 2 * static_cast<int>(hands_.size());
  ++forces_;                                  // F
  const Eigen::Index unknowns = forces_ + 1;  // and by how much all rows give way
  const auto rows = static_cast<Eigen::Index>(names_.size());
  bears_ = RowMatrix::Zero(nv_, forces_);
  A_ = Eigen::MatrixXd::Zero(base_rows, unknowns);
  G_ = Eigen::MatrixXd::Zero(rows, unknowns);
  KKT_ = Eigen::MatrixXd::Zero(unknowns + base_rows, unknowns + base_rows);
  b_ = y_ = Eigen::VectorXd::Zero(base_rows);
  c_ = x_ = dx_ = Eigen::VectorXd::Zero(unknowns);
  h_ = w_ = z_ = dw_ = dz_ = rows_ = Eigen::VectorXd::Zero(rows);
  rhs_ = solution_ = Eigen::VectorXd::Zero(unknowns + base_rows);
  loads_.assign(names_.size(), -1);
  for (RowMatrix* part :
       {&at_.jacobian, &at_.velocity_dq, &at_.acceleration_dq, &at_.acceleration_dv})
    part->setZero(6, nv_);
  lu_ = Eigen::PartialPivLU<Eigen::MatrixXd>(unknowns + base_rows);
  constexpr double dear = 100.0;  // giving way, beside force
  if (!hands_.empty()) c_[forces_ - 1] = -1.0;
  c_[forces_] = dear;
}

/// In the order in which fill() makes them.
void Bearing::name_rows(const Model& model) {
  const auto add = [&](int count, const std::string& name) {
    for (int i = 0; i < count; ++i) names_.push_back(name);
  };
  for (const SupportSpec& foot : spec_.feet) {
    add(octagon, "friction of " + foot.frame);
    add(1, "load of " + foot.frame);
    if (foot.is_sole()) add(6, "pressure of " + foot.frame);
  }
  if (spec_.hand_friction > 0.0)
    for (const std::string& hand : spec_.hands) add(octagon, "friction of " + hand);
  for (const int k : limited_) add(2, "torque limits/" + model.v_name(k));
  add(2, "force");  // of some size, and giving way is none that pushes
}

void Bearing::fill_cone(Eigen::Index x, Eigen::Index y, Eigen::Index z, double friction,
                        Eigen::Index& row) noexcept {
  for (int side = 0; side < octagon; ++side, ++row) {
    const double angle = (side + 0.5) * 2.0 * M_PI / octagon;  // corners on x and y
    G_(row, x) = std::cos(angle);
    G_(row, y) = std::sin(angle);
    G_(row, z) = -friction * std::cos(M_PI / octagon);
    loads_[static_cast<std::size_t>(row)] = z;
  }
}

void Bearing::fill_foot(const RigidBody& body, std::size_t foot, Eigen::Index column,
                        Eigen::Index& row) noexcept {
  const SupportSpec& support = spec_.feet[foot];
  const int held = support.is_sole() ? 6 : 3;
  body.frame_derivatives(feet_[foot], Reference::centered(), at_);
  // A sole's forces are along its axes, a ball's along the world's.
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  if (held == 6) R = body.placement(feet_[foot]).linear();
  for (int part = 0; part < held / 3; ++part)
    for (int i = 0; i < 3; ++i) {
      const double unit = part == 0 ? weight_ : moment_arm * weight_;
      for (int k = 0; k < nv_; ++k) {
        double sum = 0.0;
        for (int j = 0; j < 3; ++j) sum += at_.jacobian(3 * part + j, k) * R(j, i);
        bears_(k, column + 3 * part + i) = unit * sum;
      }
    }
  fill_cone(column, column + 1, column + 2, support.friction, row);
  G_(row, column + 2) = -1.0;
  h_[row++] = -spec_.least_load / weight_;
  if (held < 6) return;
  const std::array<double, 3> most{
      support.half_y, support.half_x,
      support.friction * std::hypot(support.half_x, support.half_y) / 3.0};
  for (int i = 0; i < 3; ++i)
    for (const double sign : {-1.0, 1.0}) {
      G_(row, column + 3 + i) = sign;
      G_(row, column + 2) = -most[static_cast<std::size_t>(i)] / moment_arm;
      loads_[static_cast<std::size_t>(row++)] = column + 2;
    }
}

void Bearing::fill(const RigidBody& body) noexcept {
  G_.setZero();
  h_.setZero();
  bears_.setZero();
  Eigen::Index row = 0, column = 0;
  for (std::size_t foot = 0; foot < feet_.size(); ++foot) {
    fill_foot(body, foot, column, row);
    column += spec_.feet[foot].is_sole() ? 6 : 3;
  }
  const Eigen::Index force = forces_ - 1;
  const Eigen::Matrix3d axes = Reference::surface_with_normal(spec_.normal_world).rotation;
  for (const int hand : hands_) {
    body.frame_derivatives(hand, Reference::centered(), at_);
    const bool rubs = spec_.hand_friction > 0.0;
    for (int k = 0; k < nv_; ++k) {
      const Eigen::Vector3d moves(at_.jacobian(0, k), at_.jacobian(1, k), at_.jacobian(2, k));
      bears_(k, force) += weight_ * moves.dot(axes.col(2));
      if (!rubs) continue;
      bears_(k, column) = weight_ * moves.dot(axes.col(0));
      bears_(k, column + 1) = weight_ * moves.dot(axes.col(1));
    }
    if (!rubs) continue;
    fill_cone(column, column + 1, force, spec_.hand_friction, row);
    column += 2;
  }
  const VectorView gravity = body.gravity_torque();
  for (int k = 0; k < base_rows; ++k) {
    for (Eigen::Index j = 0; j < forces_; ++j) A_(k, j) = bears_(k, j) / weight_;
    b_[k] = gravity[k] / weight_;
  }
  for (const int k : limited_) {  // tau = g - J^T f
    const double most = spec_.torque_limit[k];
    for (const double sign : {-1.0, 1.0}) {
      for (Eigen::Index j = 0; j < forces_; ++j) G_(row, j) = -sign * bears_(k, j) / most;
      h_[row++] = 1.0 - sign * gravity[k] / most;
    }
  }
  G_.col(forces_).head(row).setConstant(-1.0);
  constexpr double largest = 100.0;  // weights, so that there is an end
  G_(row, force) = 1.0;
  h_[row++] = largest;
  G_(row++, forces_) = -1.0;
}

bool Bearing::step() noexcept {
  const Eigen::Index n = x_.size(), m = w_.size();
  const double mean = w_.dot(z_) / static_cast<double>(m);
  constexpr double centre = 0.15, damping = 1e-11;
  // What a row asks of z beside D G dx, D = z / w.
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
  const double primal = room(w_, dw_), dual = room(z_, dz_);
  x_ += primal * dx_;
  w_ += primal * dw_;
  y_ += dual * solution_.tail(base_rows);
  z_ += dual * dz_;
  return true;
}

bool Bearing::solve() noexcept {
  constexpr int most = 60;
  constexpr double enough = 1e-6;
  x_.setZero();
  y_.setZero();
  w_.setOnes();
  z_.setOnes();
  for (int i = 0; i < most; ++i) {
    if (!step()) return false;
    if (w_.dot(z_) < enough && rows_.cwiseAbs().maxCoeff() < enough &&
        rhs_.tail(base_rows).cwiseAbs().maxCoeff() < enough)
      return true;
  }
  return false;
}

double Bearing::amount(Eigen::Index row) const noexcept {
  const Eigen::Index load = loads_[static_cast<std::size_t>(row)];
  if (load >= 0) return std::abs(G_(row, load)) * x_[load];
  constexpr double whole = 1.0;  // a torque's
  return names_[static_cast<std::size_t>(row)].starts_with("load") ? -h_[row] : whole;
}

double Bearing::most(const RigidBody& body) noexcept {
  fill(body);
  limit_ = static_cast<int>(names_.size()) - 1;
  if (!solve()) return -std::numeric_limits<double>::infinity();
  // The limit of which a percent more would bring the most.
  double dearest = 0.0;
  for (Eigen::Index row = 0; row + 2 < z_.size(); ++row) {
    const double brings = z_[row] * amount(row);
    if (brings > dearest) limit_ = static_cast<int>(row);
    dearest = std::max(dearest, brings);
  }
  constexpr double none = 1e-4;
  if (x_[forces_] > none) return -weight_ * x_[forces_];
  return hands_.empty() ? 0.0 : weight_ * x_[forces_ - 1];
}

}  // namespace burnish::pressing
