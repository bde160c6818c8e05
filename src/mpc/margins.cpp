#include "burnish/mpc/margins.hpp"

#include <algorithm>
#include <cmath>

#include "mpc/sampled_loop.hpp"

namespace burnish {
namespace {

// 1/s: a disturbance that grows faster takes less than half a second from a joint's noise to its
// speed limit. Simulations of 12 arms fault there.
constexpr double slow = 8.0;
// Of the way from the stated to the boosted bandwidth: boost fades by itself within 0.15 s, so that
// simulations fault where the loop is unstable half the way, not where it is at the very end.
constexpr double mean_boost = 0.5;

/// Bandwidths that the observer works at [rad/s].
std::vector<double> bandwidths(const ModelErrorOptions& options) {
  const double stated = options.usual_bandwidth(), boost = options.usual_boost();
  std::vector<double> all{stated};
  if (options.kind != ModelErrorKind::Torque) return all;
  if (options.calm < 1.0) all.push_back(options.calm * stated);
  if (boost > 1.0) all.push_back((1.0 + mean_boost * (boost - 1.0)) * stated);
  return all;
}

using Case = SampledLoop::Case;

/// The loop as `options` have it, with the observer at a bandwidth [rad/s].
Case case_of(const ModelErrorOptions& options, double bandwidth) {
  Case result{.bandwidth = bandwidth};
  if (options.kind != ModelErrorKind::Torque) return result;
  result.lag = options.usual_lag();
  result.force_gain = options.usual_force_gain();
  return result;
}

}  // namespace

struct LoopAnalysis::Impl {
  Impl(const MpcSpec& spec, const LoopChain& chain, int phase)
      : loop(spec, chain, phase), options(spec.model_error) {
    const Model& model = spec.problem.model;
    for (int k = 0; k < model.nv; ++k) joints.push_back(model.v_name(k));
  }

  int steps_of(double delay) const { return static_cast<int>(std::lround(delay / loop.dt())); }
  bool is_stable(Case with, int entry, double factor) const {
    with.entry = entry;
    with.factor = factor;
    return loop.growth(with) < slow;
  }
  double largest_delay(Case with, double furthest) const;
  double limit_of_gain(const Case& with, int entry, double furthest) const;

  SampledLoop loop;
  ModelErrorOptions options;
  std::vector<std::string> joints;
};

/// At most `furthest` [s]. Between two steps of delay by how fast the growth rises beyond them.
double LoopAnalysis::Impl::largest_delay(Case with, double furthest) const {
  const auto excess = [&](int steps) {
    with.delay_steps = steps;
    return loop.growth(with) - slow;
  };
  int stable = -1, unstable = static_cast<int>(std::ceil(furthest / loop.dt() - 1e-9));
  if (excess(unstable) < 0.0) return furthest;
  while (unstable - stable > 1) {
    const int middle = (stable + unstable) / 2;
    (excess(middle) < 0.0 ? stable : unstable) = middle;
  }
  const double first = excess(unstable), rise = excess(unstable + 1) - first;
  const double back = rise > 0.0 ? std::min(1.0, first / rise) : 1.0;
  return std::clamp((unstable - back) * loop.dt(), 0.0, furthest);
}

/// Factor between 1 and `furthest` from which on the loop is unstable; 1 where it is without.
double LoopAnalysis::Impl::limit_of_gain(const Case& with, int entry, double furthest) const {
  if (is_stable(with, entry, furthest)) return furthest;
  if (!is_stable(with, entry, 1.0)) return 1.0;
  constexpr double precision = 0.05;  // of the logarithm
  double stable = 0.0, unstable = std::log(furthest);
  while (std::abs(unstable - stable) > precision) {
    const double middle = 0.5 * (stable + unstable);
    (is_stable(with, entry, std::exp(middle)) ? stable : unstable) = middle;
  }
  return std::exp(stable);
}

LoopAnalysis::LoopAnalysis(const MpcSpec& spec, const LoopChain& chain, int phase) {
  if (const std::string why = without_margins(spec); !why.empty()) throw Error(why);
  impl_ = std::make_unique<Impl>(spec, chain, phase);
}
LoopAnalysis::~LoopAnalysis() = default;
LoopAnalysis::LoopAnalysis(LoopAnalysis&&) noexcept = default;
LoopAnalysis& LoopAnalysis::operator=(LoopAnalysis&&) noexcept = default;

double LoopAnalysis::growth(double bandwidth, double extra_delay) const {
  Case with = case_of(impl_->options, bandwidth);
  with.delay_steps = impl_->steps_of(extra_delay);
  return impl_->loop.growth(with);
}

bool LoopAnalysis::tolerates(const ModelErrorOptions& options, double delay, double factor) const {
  for (const double bandwidth : bandwidths(options)) {
    const Case with = case_of(options, bandwidth);
    Case late = with;
    late.delay_steps = impl_->steps_of(delay);
    if (!impl_->is_stable(late, -1, 1.0)) return false;
    for (int k = 0; k < impl_->loop.nv(); ++k)
      for (const double gain : {factor, 1.0 / factor})
        if (!impl_->is_stable(with, k, gain)) return false;
  }
  return true;
}

LoopMargins LoopAnalysis::delay_margin(const ModelErrorOptions& options) const {
  LoopMargins result{.delay = longest_delay, .bandwidth = options.usual_bandwidth()};
  for (const double bandwidth : bandwidths(options)) {
    const double delay = impl_->largest_delay(case_of(options, bandwidth), result.delay);
    if (delay < result.delay) result.bandwidth = bandwidth;
    result.delay = delay;
  }
  return result;
}

LoopMargins LoopAnalysis::margins(const ModelErrorOptions& options) const {
  LoopMargins result = delay_margin(options);
  for (int k = 0; k < impl_->loop.nv(); ++k) {
    GainRange range{impl_->joints[static_cast<std::size_t>(k)], smallest_gain, largest_gain};
    for (const double bandwidth : bandwidths(options)) {
      range.below = impl_->limit_of_gain(case_of(options, bandwidth), k, range.below);
      range.above = impl_->limit_of_gain(case_of(options, bandwidth), k, range.above);
    }
    result.gains.push_back(std::move(range));
  }
  return result;
}

std::string without_margins(const MpcSpec& spec) {
  const Model& model = spec.problem.model;
  if (!model.joints.empty() && model.joints.front().kind == JointKind::FreeFlyer)
    return "margins: the base of the robot floats; they are computed for a fixed one";
  if (!model.loops.empty())
    return "margins: the robot has loops; they are computed for open chains";
  if (!spec.supports.empty())
    return "margins: the robot stands on supports; they are computed for arms";
  if (!spec.base.empty())
    return "margins: the robot carries the surface; they are computed for one that stands";
  if (!spec.force_sensor)
    return "margins: the force is estimated from torques; they are computed for a force sensor";
  if (spec.model_error.kind == ModelErrorKind::Force)
    return "margins: the error of the force is estimated; they are computed for that of torques";
  return {};
}

int free_phase(const MpcSpec& spec) {
  for (std::size_t i = 0; i < spec.schedule.size(); ++i)
    if (!presses_in(spec, static_cast<int>(i))) return static_cast<int>(i);
  return -1;
}

int pressing_phase(const MpcSpec& spec) {
  for (std::size_t i = spec.schedule.size(); i-- > 0;)
    if (presses_in(spec, static_cast<int>(i))) return static_cast<int>(i);
  return -1;
}

}  // namespace burnish
