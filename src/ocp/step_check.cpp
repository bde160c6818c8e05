// Checks the discretisation error of a plan's steps by comparison with small steps.
#include "burnish/ocp/step_check.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "model/joint_entries.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish {
namespace {

// Limits of the errors, explained at check_steps().
constexpr double min_position_limit = 0.01;  // smallest limit of a position error [rad or m]
constexpr double min_velocity_limit = 0.1;   // smallest limit of a velocity error [rad/s or m/s]
constexpr double max_delay = 0.025;          // (limit of a position error) / (largest speed) [s]
constexpr double max_speed_fraction = 0.1;   // (limit of a velocity error) / (largest speed)

/// Largest difference between the results of n and of 2 n small steps, as a fraction of the plan's
/// error or, if larger, of the limit of this error. Chosen by hand.
constexpr double convergence = 0.02;
/// Largest number of small steps into which a knot's step is divided; chosen by hand.
constexpr int max_small_steps = 256;

/// Returns the value as text with three significant digits.
std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// Returns the stage without costs, constraints and frames, which do not affect the motion.
ocp::CompiledStage dynamics_only(ocp::CompiledStage stage) {
  stage.terms.clear();
  stage.costs = 0;
  stage.row_lower.clear();
  stage.frames.clear();
  stage.has_momentum = false;
  return stage;
}

/// Returns the problem with memory for Runge-Kutta steps.
ocp::CompiledProblem with_dense_stages(ocp::CompiledProblem compiled) {
  compiled.has_dense_stages = true;
  compiled.has_custom = false;
  return compiled;
}

using States = std::vector<NativePack>;  // states of all lanes, nx entries
using Inside =
    std::remove_reference_t<decltype(ocp::ProblemInside::of(std::declval<const Problem&>()))>;

class StepCheck {
 public:
  StepCheck(const Problem& problem, const MatrixView& xs, const MatrixView& us)
      : problem_(problem),
        impl_(ocp::ProblemInside::of(problem)),
        compiled_(with_dense_stages(impl_.compiled)),
        worker_(compiled_),
        xs_(xs),
        us_(us) {
    set_limits();
  }

  StepReport report() {
    for (int k = 0; k <= problem_.knots(); ++k)
      if (!xs_.row(k).allFinite() ||
          (k < problem_.knots() && !us_.row(k).head(problem_.controls(k)).allFinite())) {
        report_.status = Status::NotFinite;
        report_.knot = k;
        report_.coarse = true;
        return report_;
      }
    for (const KnotRange& range : problem_.ranges()) check_range(range);
    report_.coarse = report_.coarse || report_.position.error > report_.position.limit ||
                     report_.velocity.error > report_.velocity.limit;
    if (report_.coarse && report_.status == Status::Ok) find_step();
    return report_;
  }

 private:
  int nv() const { return problem_.layout().nv; }

  void set_limits() {
    const StateLayout& l = problem_.layout();
    largest_speed_ = Eigen::VectorXd::Zero(l.nv);
    for (int k = 0; k <= problem_.knots(); ++k)
      largest_speed_ =
          largest_speed_.cwiseMax(xs_.row(k).segment(l.nq, l.nv).transpose().cwiseAbs());
  }
  /// Returns the error limit of an entry of dx.
  double limit(int entry) const {
    return entry < nv()
               ? std::max(min_position_limit, max_delay * largest_speed_[entry])
               : std::max(min_velocity_limit, max_speed_fraction * largest_speed_[entry - nv()]);
  }

  /// Integrates the states x of a range over a fraction of the knots' steps, in `steps` parts.
  void integrate(const ocp::CompiledStage& stage, KnotRange range, int steps, double fraction,
                 States& x) {
    ocp::KnotTime<NativePack> time = times_;
    for (int l = 0; l < native_lanes; ++l) {
      const int knot = std::min(range.begin + l, range.end - 1);
      const ocp::KnotTime<double> small =
          compiled_.timing(stage, fraction * problem_.step_of(knot) / steps);
      time.step.v[l] = small.step;
      time.per_second.v[l] = small.per_second;
      time.decay.v[l] = small.decay;
      time.half_decay.v[l] = small.half_decay;
    }
    time.times = lane_times_;
    for (Status& status : statuses_) status = Status::Ok;
    for (int i = 0; i < steps; ++i) {
      worker_.pack.values(stage, x.data(), worker_.u.data(), worker_.targets.data(), time);
      std::copy_n(worker_.pack.next.begin(), x.size(), x.begin());
      for (int l = 0; l < native_lanes; ++l)
        statuses_[l] = worst(statuses_[l], worker_.pack.status(l));
    }
  }

  /// Returns the absolute differences in q and v between two states of a lane, 2 nv entries.
  Eigen::VectorXd difference(const States& a, const States& b, int lane) const {
    const StateLayout& l = problem_.layout();
    std::vector<double> from(a.size()), to(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      from[i] = a[i].v[lane];
      to[i] = b[i].v[lane];
    }
    Eigen::VectorXd dx(l.ndx());
    problem_.difference(from.data(), to.data(), dx.data());
    return dx.head(2 * l.nv).cwiseAbs();
  }

  /// Integrates over a fraction of the knots' steps with smaller and smaller Runge-Kutta steps,
  /// into `small_`. Returns false if the results do not converge.
  bool refine(const ocp::CompiledStage& stage, KnotRange range, double fraction,
              const States& coarse) {
    ocp::CompiledStage exact = stage;
    exact.integrator = Integrator::RungeKutta4;
    exact.dense = true;
    States before = start_;
    integrate(exact, range, 1, fraction, before);
    for (int n = 2; n <= max_small_steps; n *= 2) {
      small_ = start_;
      integrate(exact, range, n, fraction, small_);
      if (has_converged(before, coarse, range)) return true;
      before = small_;
    }
    return false;
  }
  bool has_converged(const States& before, const States& coarse, KnotRange range) const {
    for (int l = 0; l < range.end - range.begin; ++l) {
      if (!is_usable(statuses_[l])) return false;
      const Eigen::VectorXd change = difference(before, small_, l);
      const Eigen::VectorXd error = difference(coarse, small_, l);
      for (int i = 0; i < 2 * nv(); ++i)
        if (!(change[i] <= convergence * std::max(limit(i), error[i]))) return false;
    }
    return true;
  }

  /// Loads the knots of a range: states into start_, controls and targets into worker_.
  void load(KnotRange range) {
    impl_.gather(worker_, range, {xs_.data(), us_.data()}, times_);
    for (int l = 0; l < native_lanes; ++l)
      lane_times_[l] = impl_.times[to_size(std::min(range.begin + l, range.end - 1))];
    start_ = worker_.x;
  }

  /// Checks the knots of a range.
  void check_range(KnotRange range) {
    const ocp::CompiledStage stage = dynamics_only(impl_.stage(range.begin));
    if (!stage.passes_time()) return;
    load(range);
    States coarse = start_;
    integrate(stage, range, 1, 1.0, coarse);
    const std::vector<Status> own(statuses_, statuses_ + native_lanes);
    const bool has_result = refine(stage, range, 1.0, coarse);
    for (int l = 0; l < range.end - range.begin; ++l) {
      Status status = worst(own[to_size(l)], statuses_[l]);
      if (is_usable(status)) status = has_result ? Status::Ok : Status::NotConverged;
      if (status == Status::Ok) {
        record(range.begin + l, difference(coarse, small_, l));
      } else if (report_.knot < 0) {
        report_.status = status;
        report_.knot = range.begin + l;
        report_.coarse = true;
      }
    }
  }

  /// Returns whether an error is worse than the error `than`. Errors above their limits are worse
  /// than errors below their limits. If both are above or both below, the larger error is worse.
  static bool is_worse(double error, double limit, const StepError& than) {
    const bool above = error > limit, was_above = than.error > than.limit;
    return above != was_above ? above : error > than.error;
  }

  void record(int knot, const Eigen::VectorXd& error) {
    for (int i = 0; i < 2 * nv(); ++i) {
      StepError& worst_yet = i < nv() ? report_.position : report_.velocity;
      if (worst_yet.knot >= 0 && !is_worse(error[i], limit(i), worst_yet)) continue;
      const int k = i < nv() ? i : i - nv();
      const Model& model = problem_.model();
      const Joint& joint = model.joints[to_size(model.joint_of_v[to_size(k)])];
      const bool slides = k - joint.v_index < sliding_entries(joint.kind);
      worst_yet = {.knot = knot,
                   .place = problem_.knot_name(knot),
                   .time = problem_.time_of(knot),
                   .step = problem_.step_of(knot),
                   .entry = model.v_name(k),
                   .unit = std::string(slides ? "m" : "rad") + (i < nv() ? "" : "/s"),
                   .error = error[i],
                   .limit = limit(i)};
    }
  }

  /// Halves the step of the worst knot until its errors are at most half their limits. Sets
  /// sufficient_step to this step, rounded down to one digit.
  void find_step() {
    const auto ratio = [](const StepError& e) { return e.knot < 0 ? 0.0 : e.error / e.limit; };
    const StepError& worst_error =
        ratio(report_.position) > ratio(report_.velocity) ? report_.position : report_.velocity;
    const KnotRange knot{worst_error.knot, worst_error.knot + 1};
    const ocp::CompiledStage stage = dynamics_only(impl_.stage(worst_error.knot));
    load(knot);
    constexpr double min_fraction = 1.0 / 1024;  // chosen by hand
    for (double fraction = 0.5; fraction >= min_fraction; fraction *= 0.5) {
      States coarse = start_;
      integrate(stage, knot, 1, fraction, coarse);
      if (!refine(stage, knot, fraction, coarse)) continue;
      const Eigen::VectorXd error = difference(coarse, small_, 0);
      bool is_accurate = true;
      for (int i = 0; i < 2 * nv(); ++i) is_accurate = is_accurate && error[i] <= 0.5 * limit(i);
      if (!is_accurate) continue;
      const double step = fraction * worst_error.step;
      const double digit = std::pow(10.0, std::floor(std::log10(step)));
      report_.sufficient_step = std::floor(step / digit * (1.0 + 1e-9)) * digit;
      return;
    }
  }

  const Problem& problem_;
  const Inside& impl_;
  ocp::CompiledProblem compiled_;
  ocp::Worker worker_;
  const MatrixView& xs_;
  const MatrixView& us_;
  Eigen::VectorXd largest_speed_;  // largest speed of each entry of v [rad/s or m/s]
  ocp::KnotTime<NativePack> times_;
  double lane_times_[native_lanes] = {};  // time of each lane [s]
  Status statuses_[native_lanes] = {};    // status of each lane after integrate()
  States start_, small_;
  StepReport report_;
};

std::string error_text(const StepError& error) {
  return rounded(error.error) + " " + error.unit + " (" + error.entry + ", " + error.place +
         " at " + rounded(error.time) + " s)";
}

}  // namespace

std::string StepReport::text() const {
  if (status != Status::Ok)
    return "discretisation: the error is unknown at knot " + std::to_string(knot) + " and later: " +
           (status == Status::NotConverged ? "small steps do not converge"
                                           : std::string(describe(status)));
  if (position.knot < 0) return "discretisation: no time passes";
  return "discretisation: largest error of a step " + error_text(position) + " and " +
         error_text(velocity);
}

std::string StepReport::warning() const {
  if (!coarse) return "";
  if (status != Status::Ok) return text();
  const auto ratio = [](const StepError& e) { return e.error / e.limit; };
  const StepError& worst_error = ratio(position) > ratio(velocity) ? position : velocity;
  return "the steps are too coarse: the step of " + rounded(worst_error.step) + " s from " +
         worst_error.place + " (at " + rounded(worst_error.time) + " s) has an error of " +
         rounded(worst_error.error) + " " + worst_error.unit + " in " +
         in_quotes(worst_error.entry) + "; wanted at most " + rounded(worst_error.limit) + " " +
         worst_error.unit +
         (sufficient_step > 0.0 ? " (steps of " + number(sufficient_step) + " s are short enough)"
                                : "");
}

StepReport check_steps(const Problem& problem, const MatrixView& xs, const MatrixView& us) {
  const auto check = [](const char* name, const MatrixView& given, int rows, int columns) {
    if (given.rows() == rows && given.cols() == columns) return;
    throw Error(std::string("check_steps: ") + name + " is " + std::to_string(given.rows()) +
                " x " + std::to_string(given.cols()) + "; wanted " + std::to_string(rows) + " x " +
                std::to_string(columns));
  };
  check("xs", xs, problem.knots() + 1, problem.layout().nx());
  check("us", us, problem.knots(), problem.max_controls());
  return StepCheck(problem, xs, us).report();
}

}  // namespace burnish
