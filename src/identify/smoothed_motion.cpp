#include "identify/smoothed_motion.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "burnish/model/state.hpp"
#include "identify/smoothing.hpp"

namespace burnish::identify_detail {
namespace {

constexpr int min_half = 3;                 // Minimum number of samples beside a window's middle
constexpr int instants_per_window = 40;     // Per motion window; more would add no information
constexpr double implausible_period = 0.5;  // Longer than the period of any controller [s]
constexpr double longer_factor = 1.5;       // Ratio of the lengths of the two motion windows

void check(const Model& model, const MotionRecord& record, const IdentificationSpec& spec) {
  for (const Joint& joint : model.joints)
    if (joint_nv(joint.kind) > 1)
      throw Error(
          "identify: joint " + in_quotes(joint.name) + " is " + std::string(name_of(joint.kind)) +
          ", and no encoder measures its motion; wanted a robot on a fixed base with joints "
          "with one coordinate");
  if (record.q.cols() != model.nq || record.tau.cols() != model.nv ||
      record.q.rows() != record.tau.rows())
    throw Error("identify: q is " + std::to_string(record.q.rows()) + " x " +
                std::to_string(record.q.cols()) + " and tau " + std::to_string(record.tau.rows()) +
                " x " + std::to_string(record.tau.cols()) + "; wanted n x " +
                std::to_string(model.nq) + " and n x " + std::to_string(model.nv));
  if (!(record.period > 0.0) || !std::isfinite(record.period))
    throw Error("identify: the period is " + number(record.period) + " s; wanted more than 0");
  if (!(spec.start >= 0.0))
    throw Error("identify: start is " + number(spec.start) + " s; wanted at least 0");
}

/// Returns half a window in steps of `period`.
int half_of(double window, double period) {
  return static_cast<int>(std::lround(0.5 * window / period));
}

}  // namespace

Eigen::MatrixXd joint_path(const Model& model, const RowMatrix& q) {
  Eigen::MatrixXd path = Eigen::MatrixXd::Zero(q.rows(), model.nv);
  for (Eigen::Index i = 1; i < q.rows(); ++i)
    path.row(i) = path.row(i - 1) +
                  difference(model, q.row(i - 1).transpose(), q.row(i).transpose()).transpose();
  return path;
}

Windows::Windows(const Model& model, const MotionRecord& record, const IdentificationSpec& spec) {
  check(model, record, spec);
  period = record.period;
  samples = record.q.rows();
  const double lasts = period * static_cast<double>(samples);
  if (!(0.5 * spec.window >= min_half * period))
    throw Error("identify: the window of " + number(spec.window) +
                " s contains fewer than 7 samples, which are " + number(period) +
                " s apart; wanted a longer window, or a record with a shorter period" +
                (period >= implausible_period
                     ? "; are its times in milliseconds instead of seconds?"
                     : ""));
  if (!(10.0 * spec.window <= lasts))
    throw Error("identify: the record lasts " + number(lasts) +
                " s; wanted at least ten windows of " + number(spec.window) + " s");
  if (!(spec.motion_window > 0.0 && spec.motion_window <= spec.window))
    throw Error("identify: motion_window is " + number(spec.motion_window) +
                " s; wanted more than 0 and at most the window of " + number(spec.window) + " s");
  motion = std::max(min_half, half_of(spec.motion_window, period));
  longer = static_cast<int>(std::ceil(longer_factor * motion));
  stride = std::max(1, 2 * motion / instants_per_window);
  spacing = static_cast<double>(stride) * period;
  torque = std::max(min_half, half_of(spec.window, spacing));
  first = static_cast<Eigen::Index>(spec.start / period) + longer;
  count = (samples - longer - first + stride - 1) / stride;
  if (count < 10 * torque)
    throw Error("identify: the record has " + std::to_string(count) +
                " smoothed samples after the first " + number(spec.start) + " s; wanted at least " +
                std::to_string(10 * torque));
}

Windows Windows::coarse() const {
  constexpr int half = 16;  // Instants on either side of a window's middle
  const int factor = std::max(1, static_cast<int>(std::lround(static_cast<double>(torque) / half)));
  Windows result = *this;
  result.stride *= factor;
  result.spacing *= factor;
  result.torque = std::max(min_half, torque / factor);
  result.count = (samples - longer - first + result.stride - 1) / result.stride;
  return result;
}

SmoothedMotion::SmoothedMotion(const Model& model, const MotionRecord& record,
                               const Windows& windows, int half) {
  const Smoother smoother(half, record.period);
  const Eigen::MatrixXd path = joint_path(model, record.q);
  const Eigen::MatrixXd torque = record.tau;
  q.resize(windows.count, model.nq);
  for (RowMatrix* matrix : {&v, &a, &tau, &tau_rate, &tau_second})
    matrix->resize(windows.count, model.nv);
  Eigen::VectorXd moved(model.nv);
  const Eigen::VectorXd start = normalized(model, record.q.row(0).transpose());
  for (Eigen::Index i = 0; i < windows.count; ++i) {
    const Eigen::Index middle = windows.first + i * windows.stride;
    for (int k = 0; k < model.nv; ++k) {
      moved[k] = smoother.at(path.col(k), middle, 0);
      v(i, k) = smoother.at(path.col(k), middle, 1);
      a(i, k) = smoother.at(path.col(k), middle, 2);
      tau(i, k) = smoother.at(torque.col(k), middle, 0);
      tau_rate(i, k) = smoother.at(torque.col(k), middle, 1);
      tau_second(i, k) = smoother.at(torque.col(k), middle, 2);
    }
    q.row(i) = integrate(model, start, moved).transpose();
  }
}

}  // namespace burnish::identify_detail
