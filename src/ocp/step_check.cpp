// A plan's steps against small ones.
#include "burnish/ocp/step_check.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "model/joint_entries.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish {
namespace {

constexpr double smallest_position = 0.01;  // rad, m: see check_steps()
constexpr double smallest_velocity = 0.1;   // rad/s, m/s
constexpr double longest_delay = 0.025;     // s at the largest speed, of positions
constexpr double largest_fraction = 0.1;    // of the largest speed, of velocities
constexpr double agreement = 0.02;          // of an error or its limit, between n and 2 n steps
constexpr int most_small_steps = 256;       // of a knot

/// Three digits.
std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// The stage without what has no part in its motion.
ocp::CompiledStage bare(ocp::CompiledStage stage) {
  stage.terms.clear();
  stage.costs = 0;
  stage.row_lower.clear();
  stage.frames.clear();
  stage.has_momentum = false;
  return stage;
}

/// With room for Runge-Kutta steps.
ocp::CompiledProblem roomy(ocp::CompiledProblem compiled) {
  compiled.has_dense_stages = true;
  compiled.has_custom = false;
  return compiled;
}

using States = std::vector<NativePack>;  // nx
using Inside =
    std::remove_reference_t<decltype(ocp::ProblemInside::of(std::declval<const Problem&>()))>;

class StepCheck {
 public:
  StepCheck(const Problem& problem, const MatrixView& xs, const MatrixView& us)
      : problem_(problem),
        impl_(ocp::ProblemInside::of(problem)),
        compiled_(roomy(impl_.compiled)),
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
    for (const KnotRange& range : problem_.ranges()) look(range);
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
  /// Of an entry of dx.
  double limit(int entry) const {
    return entry < nv()
               ? std::max(smallest_position, longest_delay * largest_speed_[entry])
               : std::max(smallest_velocity, largest_fraction * largest_speed_[entry - nv()]);
  }

  /// The states x after so many equal steps of a stage's knots, over `part` of their time.
  void integrate(const ocp::CompiledStage& stage, KnotRange range, int steps, double part,
                 States& x) {
    ocp::KnotTime<NativePack> time = times_;
    for (int l = 0; l < native_lanes; ++l) {
      const int knot = std::min(range.begin + l, range.end - 1);
      const ocp::KnotTime<double> small =
          compiled_.timing(stage, part * problem_.step_of(knot) / steps);
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

  /// Size of each entry of q and v of the difference of two lanes, 2 nv.
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

  /// What a knot's motion leads to by small steps, in `small_`; false where they do not agree.
  bool refine(const ocp::CompiledStage& stage, KnotRange range, double part, const States& coarse) {
    ocp::CompiledStage exact = stage;
    exact.integrator = Integrator::RungeKutta4;
    exact.dense = true;
    States before = start_;
    integrate(exact, range, 1, part, before);
    for (int n = 2; n <= most_small_steps; n *= 2) {
      small_ = start_;
      integrate(exact, range, n, part, small_);
      if (agree(before, coarse, range)) return true;
      before = small_;
    }
    return false;
  }
  bool agree(const States& before, const States& coarse, KnotRange range) const {
    for (int l = 0; l < range.end - range.begin; ++l) {
      if (statuses_[l] > Status::NotConverged) return false;
      const Eigen::VectorXd change = difference(before, small_, l);
      const Eigen::VectorXd error = difference(coarse, small_, l);
      for (int i = 0; i < 2 * nv(); ++i)
        if (!(change[i] <= agreement * std::max(limit(i), error[i]))) return false;
    }
    return true;
  }

  /// Loads the knots of a range: start_, and the worker's controls and targets.
  void load(KnotRange range) {
    impl_.gather(worker_, range, {xs_.data(), us_.data()}, times_);
    for (int l = 0; l < native_lanes; ++l)
      lane_times_[l] =
          impl_.times[static_cast<std::size_t>(std::min(range.begin + l, range.end - 1))];
    start_ = worker_.x;
  }

  void look(KnotRange range) {
    const ocp::CompiledStage stage = bare(impl_.stage(range.begin));
    if (!stage.passes_time()) return;
    load(range);
    States coarse = start_;
    integrate(stage, range, 1, 1.0, coarse);
    const std::vector<Status> own(statuses_, statuses_ + native_lanes);
    const bool agreed = refine(stage, range, 1.0, coarse);
    for (int l = 0; l < range.end - range.begin; ++l) {
      Status status = worst(own[static_cast<std::size_t>(l)], statuses_[l]);
      if (status <= Status::NotConverged) status = agreed ? Status::Ok : Status::NotConverged;
      if (status == Status::Ok) {
        note(range.begin + l, difference(coarse, small_, l));
      } else if (report_.knot < 0) {
        report_.status = status;
        report_.knot = range.begin + l;
        report_.coarse = true;
      }
    }
  }

  /// What is above its limit is worse than what is not; else the larger error is.
  static bool is_worse(double error, double limit, const StepError& than) {
    const bool above = error > limit, was_above = than.error > than.limit;
    return above != was_above ? above : error > than.error;
  }

  void note(int knot, const Eigen::VectorXd& error) {
    for (int i = 0; i < 2 * nv(); ++i) {
      StepError& worst_yet = i < nv() ? report_.position : report_.velocity;
      if (worst_yet.knot >= 0 && !is_worse(error[i], limit(i), worst_yet)) continue;
      const int k = i < nv() ? i : i - nv();
      const Model& model = problem_.model();
      const Joint& joint =
          model.joints[static_cast<std::size_t>(model.joint_of_v[static_cast<std::size_t>(k)])];
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

  /// The longest of 1/2, 1/4, ... of the worst knot's step whose own error is within half of the
  /// limits, rounded down to a figure.
  void find_step() {
    const auto ratio = [](const StepError& e) { return e.knot < 0 ? 0.0 : e.error / e.limit; };
    const StepError& most =
        ratio(report_.position) > ratio(report_.velocity) ? report_.position : report_.velocity;
    const KnotRange knot{most.knot, most.knot + 1};
    const ocp::CompiledStage stage = bare(impl_.stage(most.knot));
    load(knot);
    constexpr double shortest = 1.0 / 1024;
    for (double part = 0.5; part >= shortest; part *= 0.5) {
      States coarse = start_;
      integrate(stage, knot, 1, part, coarse);
      if (!refine(stage, knot, part, coarse)) continue;
      const Eigen::VectorXd error = difference(coarse, small_, 0);
      bool enough = true;
      for (int i = 0; i < 2 * nv(); ++i) enough = enough && error[i] <= 0.5 * limit(i);
      if (!enough) continue;
      const double step = part * most.step;
      const double digit = std::pow(10.0, std::floor(std::log10(step)));
      report_.step_enough = std::floor(step / digit * (1.0 + 1e-9)) * digit;
      return;
    }
  }

  const Problem& problem_;
  const Inside& impl_;
  ocp::CompiledProblem compiled_;
  ocp::Worker worker_;
  const MatrixView& xs_;
  const MatrixView& us_;
  Eigen::VectorXd largest_speed_;  // nv
  ocp::KnotTime<NativePack> times_;
  double lane_times_[native_lanes] = {};  // s
  Status statuses_[native_lanes] = {};    // of the last integration
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
    return "discretisation: cannot be judged from knot " + std::to_string(knot) + " on: " +
           (status == Status::NotConverged ? "small steps do not agree with each other"
                                           : std::string(describe(status)));
  if (position.knot < 0) return "discretisation: no time passes";
  return "discretisation: a step ends at most " + error_text(position) + " and " +
         error_text(velocity) + " off what small steps lead to";
}

std::string StepReport::warning() const {
  if (!coarse) return "";
  if (status != Status::Ok) return text();
  const auto ratio = [](const StepError& e) { return e.error / e.limit; };
  const StepError& most = ratio(position) > ratio(velocity) ? position : velocity;
  return "the steps are too coarse: the one of " + rounded(most.step) + " s from " + most.place +
         " (at " + rounded(most.time) + " s) ends " + rounded(most.error) + " " + most.unit +
         " off in " + in_quotes(most.entry) + " from where small steps lead; wanted at most " +
         rounded(most.limit) + " " + most.unit +
         (step_enough > 0.0 ? ", for which steps of " + number(step_enough) + " s would do" : "");
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
