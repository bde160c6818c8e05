#include "burnish/tasks/polishing/margins.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/tasks/polishing/task_file.hpp"

namespace burnish::polishing {
namespace {

/// Ratio of actual to stated stiffness of the surface that the gains must tolerate, because the
/// controller cannot measure it. Chosen by hand.
constexpr double stiffness_factor = 3.0;

/// Control loops in free air and in contact with the surface.
struct Loops {
  LoopAnalysis air, contact;

  bool tolerate(const ModelErrorOptions& options, const RequiredMargins& required) const {
    return contact.tolerates(options, required.delay, required.gain) &&
           air.tolerates(options, required.delay, required.gain);
  }
};

std::optional<Loops> loops_of(const Task& task, const Setting& setting, const LoopChain& chain) {
  const MpcSpec spec = make_mpc(task, setting);
  if (!without_margins(spec).empty()) return std::nullopt;
  try {
    return Loops{{spec, chain, free_phase(spec)}, {spec, chain, pressing_phase(spec)}};
  } catch (const Error&) {
    return std::nullopt;  // no plan exists at the start; the run reports the reason
  }
}

/// Returns the gain range with the lowest upper end (`above`) or else the highest lower end.
GainRange narrowest(const TaskMargins& margins, bool above) {
  std::vector<GainRange> all = margins.air.gains;
  all.insert(all.end(), margins.contact.gains.begin(), margins.contact.gains.end());
  return *std::min_element(all.begin(), all.end(), [&](const GainRange& a, const GainRange& b) {
    return above ? a.above < b.above : a.below > b.below;
  });
}

std::string rounded(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Returns the text of one end of a gain range: "0.1 or less (joint_a)". If `is_bound`, the search
/// ended at its bound, and the text contains `beyond`, such as " or less".
std::string range_end(const std::string& joint, double gain, bool is_bound, const char* beyond) {
  return rounded(gain, "%.2g") + (is_bound ? beyond : "") + " (" + joint + ")";
}

/// Returns the delay from torques to measured velocities [s], without the motor lag that plans
/// model. Velocities from differences of positions are half a tick old.
double lag_of(const LoopChain& chain, double tick_period) {
  double lag = chain.command_delay;
  if (chain.difference_velocity) lag += 0.5 * tick_period;
  if (chain.difference_velocity && chain.velocity_cutoff > 0.0) lag += 1.0 / chain.velocity_cutoff;
  return lag;
}

/// Returns the task with the gains from which the fit starts. They were tuned with the right arm of
/// Talos.
Task with_first_gains(Task task) {
  ModelErrorOptions& error = task.model_error;
  // The estimate of the force error must be slower than the filter of the force sensor
  // (ModelErrorOptions).
  if (!error.bandwidth) error.bandwidth = error.kind == ModelErrorKind::Force ? 50.0 : 120.0;
  if (!error.transient_scale) error.transient_scale = 6.0;
  const bool observes = error.kind == ModelErrorKind::Torque;
  if (!error.lag) error.lag = observes ? lag_of(usual_chain(task), 1.0 / task.tick_rate) : 0.0;
  if (!error.force_gain) error.force_gain = observes ? 0.5 : 0.0;
  if (!task.weights.position) task.weights.position = 1e4;
  return task;
}

/// Fit of the gains that a task does not state. The fit selects the fastest gains that the loops
/// tolerate.
class Fit {
 public:
  Fit(const Task& task, const Setting& setting, const RequiredMargins& required)
      : first_(with_first_gains(task)),
        task_(first_),
        setting_(setting),
        fits_transient_scale_(!task.model_error.transient_scale),
        fits_bandwidth_(!task.model_error.bandwidth),
        fits_position_(!task.weights.position),
        fits_force_gain_(!task.model_error.force_gain),
        required_(required) {}

  /// Fits the gains to the required margins. Returns false in two cases: no choice has these
  /// margins (task() then has the slowest gains), or margins cannot be computed (task() then has
  /// the initial gains).
  bool find() {
    if (fits_force_gain_) task_.model_error.force_gain = 0.0;
    const bool found = find_without_force();
    if (fits_force_gain_ && has_loops_) find_force_gain();
    return found;
  }
  const Task& first() const { return first_; }
  const Task& task() const { return task_; }
  bool has_loops() const { return has_loops_; }

 private:
  bool find_without_force() {
    constexpr std::array raised{10.0, 3.0, 1.0};  // factors on weights.position, tried first
    // Factors on weights.position, tried last (after `raised` and `slowed`).
    constexpr std::array lowered{0.3, 0.1, 0.03};
    constexpr std::array slowed{0.7, 0.5, 0.35, 0.25};  // factors on model_error.bandwidth
    for (const double factor : raised)
      if ((fits_position_ || factor == 1.0) && try_position(factor)) return true;
    if (!has_loops_) return false;
    if (fits_bandwidth_)
      for (const double factor : slowed)
        if (try_bandwidth(factor)) return true;
    if (fits_position_)
      for (const double factor : lowered)
        if (try_position(factor)) return true;
    return false;
  }
  /// Sets the largest of the tried force gains that the loop tolerates together with the other
  /// gains, on the stated surface and on a stiffer one; 0 if it tolerates none.
  void find_force_gain() {
    constexpr std::array factors{1.0, 0.7, 0.5};  // factors on model_error.force_gain
    LoopChain chain = usual_chain(task_);
    chain.stiffness *= stiffness_factor;
    const MpcSpec spec = make_mpc(task_, setting_);
    const LoopAnalysis stiff(spec, chain, pressing_phase(spec));
    ModelErrorOptions& error = task_.model_error;
    for (const double factor : factors) {
      error.force_gain = factor * *first_.model_error.force_gain;
      if (loops_->contact.tolerates(error, required_.delay, required_.gain) &&
          stiff.tolerates(error, required_.delay, required_.gain))
        return;
    }
    error.force_gain = 0.0;
  }
  bool try_position(double factor) {
    task_.weights.position = factor * *first_.weights.position;
    loops_ = loops_of(task_, setting_, usual_chain(task_));
    has_loops_ = loops_.has_value();
    return has_loops_ && try_transient_scales();
  }
  bool try_bandwidth(double factor) {
    task_.model_error.bandwidth = factor * *first_.model_error.bandwidth;
    return try_transient_scales();
  }
  bool try_transient_scales() {
    // Factors on transient_scale - 1, tried in this order.
    constexpr std::array fractions{1.0, 0.5, 0.3, 0.1, 0.0};
    const double max_scale = *first_.model_error.transient_scale;
    return std::any_of(fractions.begin(), fractions.end(), [&](double fraction) {
      if (fraction < 1.0 && (!fits_transient_scale_ || max_scale <= 1.0)) return false;
      task_.model_error.transient_scale = 1.0 + fraction * (max_scale - 1.0);
      return loops_->tolerate(task_.model_error, required_);
    });
  }

  const Task first_;
  Task task_;
  const Setting& setting_;
  bool fits_transient_scale_, fits_bandwidth_, fits_position_, fits_force_gain_;
  RequiredMargins required_;
  std::optional<Loops> loops_;
  bool has_loops_ = true;
};

}  // namespace

std::string TaskMargins::text() const {
  const GainRange lower = narrowest(*this, false), upper = narrowest(*this, true);
  const bool is_far = delay() >= LoopAnalysis::max_delay;
  return rounded(1e3 * delay(), "%.1f ms") + (is_far ? " or more" : "") + " of extra delay (" +
         (air.delay < contact.delay ? "in free air" : "in contact") + "), gains of " +
         range_end(lower.joint, lower.below, lower.below <= LoopAnalysis::smallest_gain,
                   " or less") +
         " to " +
         range_end(upper.joint, upper.above, upper.above >= LoopAnalysis::largest_gain, " or more");
}

LoopChain chain_of(const Disturbances& disturbances, double stiffness, double damping) {
  return {.command_delay = disturbances.command_delay,
          .torque_cutoff = disturbances.torque_cutoff,
          .difference_velocity = disturbances.finite_difference_velocity,
          .velocity_cutoff = disturbances.velocity_cutoff,
          .force_cutoff = disturbances.force_cutoff,
          .stiffness = stiffness,
          .damping = damping};
}

LoopChain usual_chain(const Task& task) {
  Disturbances usual = disturbance_preset("sensors");
  usual.torque_cutoff = task.torque_cutoff;
  return chain_of(usual, task.stiffness, task.damping);
}

LoopChain loop_chain(const Task& task) {
  return chain_of(task.disturbances, task.stiffness, task.damping);
}

std::optional<TaskMargins> margins(const Task& task, const Setting& setting) {
  return margins(task, setting, usual_chain(task));
}

std::optional<TaskMargins> margins(const Task& task, const Setting& setting,
                                   const LoopChain& chain) {
  Task fitted = task;
  (void)fit_gains(fitted, setting);
  const std::optional<Loops> loops = loops_of(fitted, setting, chain);
  if (!loops) return std::nullopt;
  return TaskMargins{loops->air.margins(fitted.model_error),
                     loops->contact.margins(fitted.model_error)};
}

FittedGains fit_gains(Task& task, const Setting& setting, const RequiredMargins& required) {
  if (task.model_error.transient_scale && task.model_error.bandwidth && task.weights.position)
    return {};
  const ModelErrorOptions stated = task.model_error;
  Fit fit(task, setting, required);
  FittedGains result{.meets = fit.find()};
  const Task& before = fit.first();
  task = fit.has_loops() ? fit.task() : before;
  if (!fit.has_loops()) {
    // Discards the fitted lag and force gain, because no loop could be analysed with them.
    task.model_error.lag = stated.usual_lag();
    task.model_error.force_gain = stated.usual_force_gain();
    return {};
  }
  const auto note = [&](const char* key, double was, double now) {
    if (was != now)
      result.changes += (result.changes.empty() ? "" : ", ") + std::string(key) + " " +
                        number(now) + " in place of " + number(was);
  };
  note("model_error.transient_scale", *before.model_error.transient_scale,
       *task.model_error.transient_scale);
  note("model_error.bandwidth", *before.model_error.bandwidth, *task.model_error.bandwidth);
  note("model_error.force_gain", *before.model_error.force_gain, *task.model_error.force_gain);
  note("weights.position", *before.weights.position, *task.weights.position);
  if (!result.changes.empty() && result.meets)
    result.changes += ", with which the arm tolerates " + rounded(1e3 * required.delay, "%g ms") +
                      " of extra delay and a factor of " + number(required.gain) +
                      " in each joint's gain";
  return result;
}

}  // namespace burnish::polishing
