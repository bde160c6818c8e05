#include "burnish/mpc/margins.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "mpc/plan_inputs.hpp"
#include "mpc/sampled_loop.hpp"

namespace burnish {
namespace {

// Largest growth rate with which the loop still counts as stable [1/s]. With this rate, a
// disturbance needs about half a second to grow from joint noise to the speed limit. In simulations
// of 12 arms, faster growth led to faults.
constexpr double max_growth = 8.0;
// Mean increase of the observer's bandwidth in a transient, as a fraction of the largest increase.
// The increase decays within 0.15 s. In simulations, faults occur if the loop is unstable at this
// fraction, but not if it is unstable only at the largest bandwidth.
constexpr double mean_transient_scale = 0.5;

/// Returns the observer bandwidths at which the loop is analysed [rad/s].
std::vector<double> bandwidths(const ModelErrorOptions& options) {
  const double stated = options.usual_bandwidth(),
               transient_scale = options.usual_transient_scale();
  std::vector<double> all{stated};
  if (options.kind != ModelErrorKind::Torque) return all;
  if (options.quiescent_scale < 1.0) all.push_back(options.quiescent_scale * stated);
  if (transient_scale > 1.0)
    all.push_back((1.0 + mean_transient_scale * (transient_scale - 1.0)) * stated);
  return all;
}

using Case = SampledLoop::Case;

/// Returns the parameters of the loop for `options`, with an observer of the given bandwidth
/// [rad/s].
Case case_of(const ModelErrorOptions& options, double bandwidth) {
  Case result{.bandwidth = bandwidth};
  if (options.kind != ModelErrorKind::Torque) return result;
  result.lag = options.usual_lag();
  result.force_gain = options.usual_force_gain();
  return result;
}

/// Returns true if the tool has a contact in the stage of a phase. `phase`: index in
/// `spec.schedule`.
bool presses_in(const MpcSpec& spec, int phase) {
  const std::string& name = spec.schedule[to_size(phase)].stage;
  const auto is_tool = [&](const std::string& frame) {
    return !spec.tools.empty() && frame == spec.tools.front().frame;
  };
  for (const Stage& stage : spec.problem.stages)
    for (const ContactSpec& contact : spec.problem.contacts)
      if (stage.name == name && is_tool(contact.tool) &&
          std::find(stage.contacts.begin(), stage.contacts.end(), contact.name) !=
              stage.contacts.end())
        return true;
  return false;
}

/// Returns the loop at the start of a phase. The surface must be fixed to the world.
SampledLoopSpec loop_spec(const MpcSpec& spec, int phase) {
  const ProblemSpec& problem = spec.problem;
  const MpcSpec filled = completed(spec);
  const ToolSpec tool = filled.tools.empty() ? ToolSpec{.frame = {}} : filled.tools.front();
  return {.plan = plan_slopes(filled.problem, filled.schedule, phase, filled.solver,
                              filled.model_error.decay_time),
          .model = problem.model,
          .q = problem.initial_state.head(problem.model.nq),
          .tool = tool.frame,
          .presses = presses_in(spec, phase),
          .normal_world = tool.normal_base,
          .observes = spec.model_error.kind == ModelErrorKind::Torque,
          .feedback = spec.feedback,
          .tick_period = spec.tick_period,
          .update_period = spec.update_period,
          .solver_delay = spec.solver_delay,
          .torque_cutoff = problem.torque_model ? problem.torque_model->cutoff : 0.0};
}

}  // namespace

struct LoopAnalysis::Impl {
  Impl(const MpcSpec& spec, const LoopChain& chain, int phase)
      : loop(loop_spec(spec, phase), chain), options(spec.model_error) {
    const Model& model = spec.problem.model;
    for (int k = 0; k < model.nv; ++k) joints.push_back(model.v_name(k));
  }

  int steps_of(double delay) const { return static_cast<int>(std::lround(delay / loop.dt())); }
  bool is_stable(Case with, int entry, double factor) const {
    with.entry = entry;
    with.factor = factor;
    return loop.growth(with) < max_growth;
  }
  double largest_delay(Case with, double furthest) const;
  double limit_of_gain(const Case& with, int entry, double furthest) const;

  SampledLoop loop;
  ModelErrorOptions options;
  std::vector<std::string> joints;
};

/// Returns the largest additional delay with which the loop is stable, at most `furthest` [s].
/// Tried delays are multiples of the plant's step. Between two multiples, the result is
/// extrapolated from the growth rates at the next two unstable delays.
double LoopAnalysis::Impl::largest_delay(Case with, double furthest) const {
  const auto excess = [&](int steps) {
    with.delay_steps = steps;
    return loop.growth(with) - max_growth;
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

/// Returns the largest gain error of one joint at which the loop is stable. The gain error is a
/// factor on the torque at index `entry`, from 1 to `furthest`. It is 1 if no factor is stable.
double LoopAnalysis::Impl::limit_of_gain(const Case& with, int entry, double furthest) const {
  if (is_stable(with, entry, furthest)) return furthest;
  if (!is_stable(with, entry, 1.0)) return 1.0;
  constexpr double precision = 0.05;  // tolerance of the factor's logarithm
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
  LoopMargins result{.delay = max_delay, .bandwidth = options.usual_bandwidth()};
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
    GainRange range{impl_->joints[to_size(k)], smallest_gain, largest_gain};
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
    return "margins: the base of the robot floats; wanted a fixed base";
  if (!model.loops.empty()) return "margins: the robot has loops; wanted an open chain";
  if (!spec.supports.empty())
    return "margins: the robot stands on supports; wanted an arm without supports";
  if (spec.tools.size() > 1)
    return "margins: the controller has " + std::to_string(spec.tools.size()) +
           " tools; wanted at most one";
  for (const ToolSpec& tool : spec.tools) {
    if (!tool.base.empty())
      return "margins: the robot carries the surface; wanted a surface fixed to the world";
    if (wrench_column(spec, tool.frame) < 0)
      return "margins: the force is estimated from torques; wanted a force sensor";
  }
  if (spec.model_error.kind == ModelErrorKind::Force)
    return "margins: model_error.kind is force; wanted torque or none";
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
