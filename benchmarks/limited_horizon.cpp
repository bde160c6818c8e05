#include "limited_horizon.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "solver/dense.hpp"

namespace burnish::bench {

using Eigen::VectorXd;

namespace {

constexpr double no_limit = 1e300;
constexpr double nominal_force = 14.0, friction = 0.6, half_sole = 0.06;
/// Weight of deviations of the normal force; chosen by hand [1/N^2].
constexpr double force_cost = 2e-3;

}  // namespace

LimitedRobot::LimitedRobot(const RobotSize& of, double load) : size(of), load_(load) {
  const int nv = size.nv, nu = size.nu;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto draw = [&](int rows, int columns) {
    return RowMatrix(RowMatrix::NullaryExpr(rows, columns, [&] { return normal(random); }));
  };
  // The eigenvalues of the mass matrix are from 0.3 to 3.
  const RowMatrix turn = Eigen::HouseholderQR<RowMatrix>(draw(nv, nv)).householderQ();
  VectorXd inverse(nv);
  for (int i = 0; i < nv; ++i) inverse[i] = std::pow(10.0, -i / std::max(1.0, nv - 1.0)) / 0.3;
  inverse_mass_ = turn * inverse.asDiagonal() * turn.transpose();
  // Entries of the position without motors get a larger stiffness, in place of the ground.
  stiffness_ = RowMatrix::Identity(nv, nv);
  stiffness_.topLeftCorner(nv - nu, nv - nu) *= 30.0;
  const int per_foot = size.soles ? 5 : 3, forces = size.feet * per_foot;
  force_by_torque_ = 0.7 * draw(forces, nu) / std::sqrt(nu);
  force_by_position_ = 5.0 * draw(forces, nv) / std::sqrt(nv);
  force_by_velocity_ = draw(forces, nv) / std::sqrt(nv);
  for (int foot = 0; size.soles && foot < size.feet; ++foot)
    for (RowMatrix* of_forces : {&force_by_torque_, &force_by_position_, &force_by_velocity_})
      of_forces->middleRows(foot * per_foot + 3, 2) *= 0.05;  // torques about the foot
  const auto between = [&](double low, double high) {
    return VectorXd(
        VectorXd::NullaryExpr(nv, [&] { return low + (high - low) * uniform(random); }));
  };
  amplitude_ = between(0.3, 0.7);
  frequency_ = between(1.5, 4.0);
  phase_ = between(0.0, 6.28);
}

VectorXd LimitedRobot::reference(double time) const {
  return (amplitude_.array() * (frequency_.array() * time + phase_.array()).sin()).matrix();
}

VectorXd LimitedRobot::start() const {
  VectorXd x = VectorXd::Zero(ndx());
  x.head(size.nv) = reference(0.0).cwiseMax(-0.5).cwiseMin(0.5);
  return x;
}

/// Sets the dynamics, and the cost of deviations from the reference.
void LimitedRobot::follow(double time, LimitedStage& s) const {
  const int nv = size.nv, nu = size.nu;
  const RowMatrix inverse = inverse_mass_ / (1.0 + 0.15 * std::sin(1.3 * time));
  const int torques = size.filtered > 0 ? nu + 2 * nv : 0;
  s.velocity = RowMatrix::Zero(nv, nz());
  s.velocity.middleCols(torques, nu) = knot_step * inverse.rightCols(nu);
  s.velocity.middleCols(nu, nv) = -knot_step * inverse * stiffness_;
  s.velocity.middleCols(nu + nv, nv) = RowMatrix::Identity(nv, nv) - 0.5 * knot_step * inverse;
  const VectorXd wanted = reference(time);
  VectorXd weight = VectorXd::Constant(nz(), 2e-3);
  s.gradient = VectorXd::Zero(nz());
  for (int i = 0; i < nv; ++i) {
    weight[nu + i] = i < nv - nu ? 1.0 : 50.0;
    weight[nu + nv + i] = 0.2;
    s.gradient[nu + i] = -weight[nu + i] * wanted[i];
  }
  weight.tail(size.filtered).setConstant(1e-3);
  s.hessian = weight.asDiagonal();
}

/// Sets costs and limit rows of the feet's forces.
void LimitedRobot::stand(double time, LimitedStage& s) const {
  const int nv = size.nv, nu = size.nu, n = nz();
  const int torques = size.filtered > 0 ? nu + 2 * nv : 0;
  RowMatrix force = RowMatrix::Zero(force_by_torque_.rows(), n);
  force.middleCols(torques, nu) = force_by_torque_;
  force.middleCols(nu, nv) = force_by_position_;
  force.middleCols(nu + nv, nv) = force_by_velocity_;
  force *= 1.0 + 0.1 * std::cos(time);
  const bool light = load_ < 0.2;
  const double carried = nominal_force + (light ? 200.0 : 0.0);
  const double wanted = nominal_force + 1.0 + 4.0 * std::sin(3.0 * time);
  const int per_foot = size.soles ? 5 : 3, rows_per_foot = rows() / std::max(1, size.feet);
  for (int foot = 0; foot < size.feet; ++foot) {
    const auto of = [&](int i) { return force.row(foot * per_foot + i); };
    s.hessian += force_cost * of(2).transpose() * of(2);
    s.gradient += force_cost * (carried - wanted) * (light ? 0.0 : 1.0) * of(2).transpose();
    int r = foot * rows_per_foot;
    const auto add = [&](double ratio, int i, double sign) {
      s.rows.row(r) = ratio * of(2) + sign * of(i);
      s.scale[n + r] = ratio * carried;
      s.lower[n + r] = -s.scale[n + r];
      ++r;
    };
    for (int i = 0; i < 2; ++i)
      for (double sign : {1.0, -1.0}) add(friction, i, sign);
    s.rows.row(r) = of(2);
    s.lower[n + r] = 4.0 - carried;
    s.upper[n + r] = (light ? 800.0 : 26.0) - carried;
    s.scale[n + r] = 0.5 * (s.upper[n + r] - s.lower[n + r]);
    ++r;
    for (int i = 3; i < per_foot; ++i)
      for (double sign : {1.0, -1.0}) add(half_sole, i, sign);
  }
}

/// Sets the ranges of torques, positions and speeds. The first state is fixed.
void LimitedRobot::bound(LimitedStage& s, bool first, bool last) const {
  const int nv = size.nv, nu = size.nu;
  const double torque = 12.0 / load_, speed = 1.6 / load_, position = 0.65 / std::sqrt(load_);
  const auto within = [&](int begin, int count, double range) {
    s.lower.segment(begin, count).setConstant(-range);
    s.upper.segment(begin, count).setConstant(range);
    s.scale.segment(begin, count).setConstant(range);
  };
  if (!last) within(0, nu, torque);
  if (first) return;
  within(nu, nv, position);
  within(nu + nv, nv, speed);
  within(nu + 2 * nv, size.filtered, torque);
}

LimitedStage LimitedRobot::stage(double time, bool first, bool last) const {
  LimitedStage s;
  const int all = nz() + rows();
  s.rows = RowMatrix::Zero(rows(), nz());
  s.lower = VectorXd::Constant(all, -no_limit);
  s.upper = VectorXd::Constant(all, no_limit);
  s.scale = VectorXd::Ones(all);
  follow(time, s);
  if (last) {
    s.hessian *= 5.0;
    s.gradient *= 5.0;
  } else {
    stand(time, s);
  }
  bound(s, first, last);
  return s;
}

std::vector<LimitedStage> LimitedRobot::horizon(double time, int knots) const {
  std::vector<LimitedStage> stages;
  for (int k = 0; k <= knots; ++k)
    stages.push_back(stage(time + k * knot_step, k == 0, k == knots));
  return stages;
}

VectorXd LimitedRobot::next(const LimitedStage& s, const VectorXd& z) const {
  const int nv = size.nv, nu = size.nu;
  VectorXd x(ndx());
  x.segment(nv, nv) = s.velocity * z;
  x.head(nv) = z.segment(nu, nv) + knot_step * x.segment(nv, nv);
  x.tail(size.filtered) =
      filter_decay * z.tail(size.filtered) + (1.0 - filter_decay) * z.head(size.filtered);
  return x;
}

LimitedHorizon::LimitedHorizon(const LimitedRobot& robot, int knots)
    : robot_(robot),
      N_(knots),
      state_{robot.ndx(), robot.ndx(), robot.size.nv, robot.size.filtered, {}},
      recursion_(state_, robot.size.nu),
      limited_(state_, knots, robot.size.nu, robot.rows()) {
  const RiccatiLayout& layout = recursion_.layout();
  const auto reserve = [&](int rows, int stride) {
    return memory_.emplace_back(dense::block_size(rows, stride)).data();
  };
  const int nu = robot.size.nu, vs = layout.value_stride;
  gaps_ = Buffer(dense::block_size(knots + 2, vs));
  hessian_gaps_ = Buffer(dense::block_size(knots + 2, vs));
  feedforwards_ = Buffer(dense::block_size(knots + 1, dense::round_up(nu)));
  for (int k = 0; k <= knots; ++k) {
    KnotExpansion e;
    e.stride = layout.expansion_stride;
    e.gradient = reserve(1, e.stride);
    e.hessian = reserve(layout.expansion_rows + dense::lanes, e.stride);
    e.dynamics = reserve(robot.ndx() + dense::lanes, e.stride);
    e.rows = reserve(robot.rows() + dense::lanes, e.stride);
    e.decay = reserve(1, dense::round_up(std::max(1, robot.size.filtered)));
    std::fill_n(e.decay, robot.size.filtered, LimitedRobot::filter_decay);
    e.step = LimitedRobot::knot_step;
    e.form = DynamicsForm::SecondOrder;
    expansions_.push_back(e);
    controls_.push_back(k < knots ? nu : 0);
    rows_.push_back(k < knots ? robot.rows() : 0);
    double* value = reserve(robot.ndx() + 1, vs);
    values_.push_back({value, value + vs});
    double* policy = reserve(nu + 1 + dense::lanes, layout.gain_stride);
    policies_.push_back({policy, policy + layout.gain_stride});
  }
}

LqHorizon LimitedHorizon::view() {
  return {expansions_,
          controls_,
          rows_,
          gaps_.data(),
          hessian_gaps_.data(),
          recursion_.layout().value_stride,
          values_,
          policies_,
          0.0};
}

void LimitedHorizon::load(const std::vector<LimitedStage>& stages, const VectorXd& x) {
  for (int k = 0; k <= N_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const LimitedStage& s = stages[i];
    const KnotExpansion& e = expansions_[i];
    const int skipped = robot_.size.nu - controls_[i], nz = robot_.nz() - skipped;
    const auto put = [&](const RowMatrix& from, Eigen::Index first, double* to) {
      for (Eigen::Index r = first; r < from.rows(); ++r)
        std::copy_n(from.data() + r * from.cols() + skipped, nz, to + (r - first) * e.stride);
    };
    std::copy_n(s.gradient.data() + skipped, nz, e.gradient);
    put(s.hessian, skipped, e.hessian);
    put(s.velocity, 0, e.dynamics);
    put(s.rows, 0, e.rows);
  }
  std::copy_n(x.data(), robot_.ndx(), gaps_.data());
  limits(stages);
}

/// Sets the limits, and the quadratic and L1 penalty weights of hard rows. As in DdpSolver, the
/// unit of the weights is the cost's curvature.
void LimitedHorizon::limits(const std::vector<LimitedStage>& stages) {
  constexpr double weight = 1000.0, l1_weight = 1e4;
  double unit = 0.0;
  const int nu = robot_.size.nu, nz = robot_.nz(), behind = limited_.first_row();
  for (int k = 0; k < N_; ++k) {
    const LimitedStage& s = stages[static_cast<std::size_t>(k)];
    for (int c = 0; c < nu; ++c) unit += s.hessian(c, c) * s.scale[c] * s.scale[c] / (nu * N_);
  }
  for (int k = 0; k <= N_; ++k) {
    const LimitedStage& s = stages[static_cast<std::size_t>(k)];
    const LimitedLq::Rows rows = limited_.rows(k);
    const int skipped = nu - controls_[static_cast<std::size_t>(k)];
    std::fill_n(rows.weight, limited_.places(), 0.0);
    for (int r = skipped; r < nz + rows_[static_cast<std::size_t>(k)]; ++r) {
      if (s.lower[r] == -no_limit && s.upper[r] == no_limit) continue;
      const int at = r < nz ? r - skipped : behind + r - nz;
      const bool always_kept = k < N_ && r < nu;
      rows.lower[at] = s.lower[r];
      rows.upper[at] = s.upper[r];
      rows.scale[at] = s.scale[r];
      rows.weight[at] = weight * unit / (s.scale[r] * s.scale[r]);
      rows.l1_weight[at] = always_kept ? no_limit : l1_weight * unit / s.scale[r];
      rows.beyond[at] = always_kept ? 0.0 : 0.5;
    }
  }
}

/// Stores the feedforward of each policy that reproduces the controls in z, also after a shortened
/// step.
void LimitedHorizon::remember() {
  const int nu = robot_.size.nu, stride = recursion_.layout().gain_stride;
  for (int k = 0; k < N_; ++k) {
    const double* z = limited_.z(k);
    const double* gain = policies_[static_cast<std::size_t>(k)].gain;
    double* out = feedforwards_.data() + k * dense::round_up(nu);
    for (int c = 0; c < nu; ++c)
      out[c] = z[c] - dense::dot(gain + c * stride, z + nu, robot_.ndx());
  }
}

LimitedLqResult LimitedHorizon::solve_warm(const LimitedLqBudget& budget, int knots) {
  const int nu = robot_.size.nu;
  for (int shifted = 0; shifted < knots; ++shifted) limited_.shift(controls_);
  for (int k = 0; k < N_; ++k)
    std::copy_n(feedforwards_.data() + std::min(k + knots, N_ - 1) * dense::round_up(nu), nu,
                policies_[static_cast<std::size_t>(k)].feedforward);
  const LimitedLqResult result = limited_.solve(view(), recursion_, budget, true);
  remember();
  return result;
}

LimitedLqResult LimitedHorizon::solve_cold(const LimitedLqBudget& budget) {
  limited_.forget();
  const LimitedLqResult result = limited_.solve(view(), recursion_, budget, false);
  remember();
  return result;
}

double LimitedHorizon::recursion() {
  const auto n = static_cast<std::size_t>(N_);
  const int vs = recursion_.layout().value_stride;
  recursion_.terminal(expansions_[n], values_[n]);
  for (std::size_t k = n; k-- > 0;)
    recursion_.step({expansions_[k], controls_[k], gaps_.data() + (k + 1) * vs, values_[k + 1],
                     policies_[k], values_[k], hessian_gaps_.data() + (k + 1) * vs},
                    {});
  return values_[0].hessian[0];
}

int LimitedHorizon::active() {
  int count = 0;
  for (int k = 0; k <= N_; ++k) {
    const LimitedLq::Rows rows = limited_.rows(k);
    for (int r = 0; r < limited_.places(); ++r)
      count += rows.weight[r] > 0.0 && rows.multiplier[r] != 0.0;
  }
  return count;
}

}  // namespace burnish::bench
