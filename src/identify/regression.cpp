#include "identify/regression.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "identify/smoothing.hpp"

namespace burnish::identify_detail {
namespace {

// Velocity scale of the smoothed sign in Coulomb friction [rad/s, m/s]
constexpr double slip_velocity = 0.02;

/// Terms of the regression at one instant, as columns: one for each entry of x, then `rest`,
/// `before`, `second` and `measured`.
class Instant {
 public:
  Instant(const Model& model, std::span<const Unknown> unknowns, const Layout& layout)
      : model_(model), unknowns_(unknowns), layout_(layout), dynamics_(model) {
    for (const Unknown& unknown : unknowns) {
      bodies_.push_back(unknown.body);
      own_.emplace_back(inertia_parameters(inertia_of_body(model, unknown.body)));
    }
    terms_.setZero(model.nv, columns(layout));
  }
  static int columns(const Layout& layout) { return layout.size + 4; }
  static int rest(const Layout& layout) { return layout.size; }
  static int before(const Layout& layout) { return layout.size + 1; }
  static int second(const Layout& layout) { return layout.size + 2; }
  static int measured(const Layout& layout) { return layout.size + 3; }

  /// Returns the terms at instant i, as a matrix of size nv x columns().
  const Eigen::MatrixXd& at(const SmoothedMotion& motion, int i) {
    add_masses(motion, i);
    for (int k = 0; k < model_.nv; ++k) {
      const double v = motion.v(i, k), a = motion.a(i, k);
      if (layout_.viscous >= 0) terms_(k, layout_.viscous + k) = v;
      if (layout_.coulomb >= 0) terms_(k, layout_.coulomb + k) = std::tanh(v / slip_velocity);
      if (layout_.offset >= 0) terms_(k, layout_.offset + k) = 1.0;
      if (layout_.armature >= 0) {
        terms_(k, layout_.armature + k) = a;
        terms_(k, rest(layout_)) += model_.armature[k] * a;
      }
      if (layout_.delay >= 0) terms_(k, layout_.delay) = -motion.tau_rate(i, k);
      terms_(k, second(layout_)) = -0.5 * motion.tau_second(i, k);
    }
    return terms_;
  }

 private:
  void add_masses(const SmoothedMotion& motion, int i) {
    (void)dynamics_.inverse(motion.q.row(i).transpose(), motion.v.row(i).transpose(),
                            motion.a.row(i).transpose(), no_force_);
    (void)dynamics_.regressor(bodies_, of_bodies_);
    auto left = terms_.col(rest(layout_));
    left = motion.tau.row(i).transpose() - dynamics_.tau();
    terms_.col(before(layout_)) = left;
    terms_.col(measured(layout_)) = motion.tau.row(i).transpose();
    for (std::size_t b = 0; b < unknowns_.size(); ++b) {
      const auto at = static_cast<Eigen::Index>(10 * b);
      const auto block = of_bodies_.middleCols<10>(at);
      terms_.middleCols<10>(at) = block * unknowns_[b].to_body;
      // A body with unknown own parameters adds nothing to the known torques.
      if (unknowns_[b].replaces) left += block * own_[b];
    }
  }

  const Model& model_;
  std::span<const Unknown> unknowns_;
  const Layout& layout_;
  ContactDynamics dynamics_;
  std::vector<int> bodies_;
  std::vector<Vector10> own_;
  RowMatrix of_bodies_;
  Eigen::MatrixXd terms_;
  Eigen::VectorXd no_force_;
};

}  // namespace

Layout::Layout(int number, int nv, const IdentificationSpec& spec)
    : inertias(number), size(10 * number) {
  const auto add = [&](bool wanted, int count) {
    const int first = wanted ? size : -1;
    if (wanted) size += count;
    return first;
  };
  viscous = add(spec.friction, nv);
  coulomb = add(spec.friction, nv);
  armature = add(spec.armature, nv);
  offset = add(spec.offset, nv);
  delay = add(spec.delay, 1);
}

int row_stride(const Windows& windows) {
  constexpr int rows_per_window = 4;  // with more rows, neighbouring rows are nearly equal
  return std::max(1, 2 * windows.torque / rows_per_window);
}

Regression::Regression(const Model& model, const SmoothedMotion& motion, const Windows& windows,
                       std::span<const Unknown> unknowns, const IdentificationSpec& spec)
    : layout(static_cast<int>(unknowns.size()), model.nv, spec), nv(model.nv) {
  set_prior(unknowns, model);
  const int half = windows.torque, stride = row_stride(windows);
  samples = (motion.instants() - 2 * half - 1) / stride + 1;
  samples_per_window = 2.0 * half / stride;
  const Eigen::VectorXd kernel = bell(half);
  Instant instant(model, unknowns, layout);
  Eigen::MatrixXd terms =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(samples) * nv, Instant::columns(layout));
  for (int i = 0; i < motion.instants(); ++i) {
    const Eigen::MatrixXd& now = instant.at(motion, i);
    // An instant contributes to all windows that contain it. Window s is centred at instant
    // half + s * stride.
    const int last = std::min(samples - 1, i / stride);
    for (int s = std::max(0, (i - 2 * half + stride - 1) / stride); s <= last; ++s)
      terms.middleRows(static_cast<Eigen::Index>(s) * nv, nv) += kernel[i - s * stride] * now;
  }
  take(terms, windows.period);
}

void Regression::set_prior(std::span<const Unknown> unknowns, const Model& model) {
  prior.setZero(size());
  prior_sigma.setConstant(size(), 1e3);  // wide prior, such as for friction [Nm, Nms/rad]
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    prior.segment<10>(static_cast<Eigen::Index>(10 * i)) = unknowns[i].eta;
    prior_sigma.segment<10>(static_cast<Eigen::Index>(10 * i)) = unknowns[i].sigma;
  }
  if (layout.armature >= 0) prior.segment(layout.armature, nv) = model.armature;
  if (layout.delay >= 0) prior_sigma[layout.delay] = 0.02;
}

void Regression::take(const Eigen::MatrixXd& terms, double period) {
  Y = terms.leftCols(10 * layout.inertias);
  linear = terms.middleCols(10 * layout.inertias, layout.linear());
  rest = terms.col(Instant::rest(layout));
  before = terms.col(Instant::before(layout));
  second = terms.col(Instant::second(layout));
  measured = terms.col(Instant::measured(layout));
  // Torque half a sampling period ago, minus the mean torque over the past sampling period.
  held = period * period / 12.0 * second;
}

Eigen::VectorXd Regression::residual(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = rest - linear * x.tail(linear.cols());
  for (int i = 0; i < layout.inertias; ++i)
    result -= Y.middleCols<10>(10 * i) * LogCholesky::parameters(x.segment<10>(10 * i));
  if (layout.delay >= 0) result -= x[layout.delay] * x[layout.delay] * second;
  return result;
}

Eigen::MatrixXd Regression::derivative(const Eigen::VectorXd& x) const {
  Eigen::MatrixXd result(rest.size(), size());
  for (int i = 0; i < layout.inertias; ++i)
    result.middleCols<10>(10 * i) =
        Y.middleCols<10>(10 * i) * LogCholesky::derivative(x.segment<10>(10 * i));
  result.rightCols(linear.cols()) = linear;
  if (layout.delay >= 0) result.col(layout.delay) += 2.0 * x[layout.delay] * second;
  return result;
}

}  // namespace burnish::identify_detail
