#include "polishing/experiments/force_catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/sentence.hpp"
#include "polishing/experiments/force_figures.hpp"
#include "report/moving_mean.hpp"
#include "report/trace_curves.hpp"

namespace burnish::polishing {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
using Measured = std::vector<MeasuredFigure>;

/// Factors from SI units to display units: ms or mm, and percent.
constexpr double milli = 1e3, percent = 1e2;

/// Returns the force along the true surface normal until the end of the path. Its times count from
/// `begin`, a time of the trace.
ForceSignal signal_since(const RunResult& result, double begin) {
  const Trace& trace = result.trace;
  const Trace::Column time = trace.column("time"), phase = trace.column("phase");
  const Eigen::VectorXd raw = along_normal(trace, "tool_force");
  const double dt = trace.rows() > 1 ? time[1] - time[0] : 1.0;
  const Eigen::VectorXd mean = moving_mean(raw, samples_in(MetricsSpec{}.average, dt));
  Eigen::Index first = 0, end = trace.rows();
  while (first < end && time[first] < begin - 1e-9) ++first;
  while (end > first && phase[end - 1] > static_cast<double>(Phase::Track)) --end;
  // Excludes the last averaging window, because it extends into the retreat.
  end = std::max(first, end - samples_in(MetricsSpec{}.average, dt));
  const Eigen::Index count = end - first;
  return {.time = time.segment(first, count).array() - begin,
          .force = mean.segment(first, count),
          .raw = raw.segment(first, count),
          .target = trace.column("target_force").segment(first, count),
          .touches = trace.column("in_contact").segment(first, count)};
}

/// Returns the start of the path; the last time of the trace if the path was not reached [s].
double path_begin(const RunResult& result) {
  const Trace& trace = result.trace;
  const auto [first, end] = rows_of_phase(trace, static_cast<double>(Phase::Track));
  return trace.column("time")[std::min<Eigen::Index>(first, trace.rows() - 1)];
}

/// Returns the force on the path, with the target force of the task. The target in the trace is
/// the controller's, which may differ.
ForceSignal signal_on_path(const Task& task, const RunResult& result) {
  ForceSignal signal = signal_since(result, path_begin(result));
  for (Eigen::Index i = 0; i < signal.time.size(); ++i)
    signal.target[i] = task.force_profile.at(task.force, signal.time[i]);
  return signal;
}

/// Returns the duration of the signal since the start of the path [s].
double path_length(const ForceSignal& signal) {
  return signal.time.size() > 0 ? signal.time[signal.time.size() - 1] : 0.0;
}

/// Returns the largest distance of the tool from its target, perpendicular to the normal, in a
/// window [m].
double farthest_off(const RunResult& result, double from, double until) {
  const Trace& trace = result.trace;
  const Trace::Column time = trace.column("time");
  const double begin = path_begin(result);
  double farthest = 0.0;
  for (const int side : {0, 1}) {
    const Eigen::Vector3d tangent = result.setting.surface_axes.col(side);
    const Eigen::VectorXd off = along(trace, "tool", tangent) - along(trace, "target", tangent);
    for (Eigen::Index i = 0; i < off.size(); ++i)
      if (time[i] - begin >= from && time[i] - begin < until)
        farthest = std::max(farthest, std::abs(off[i]));
  }
  return farthest;
}

/// Builder of the list of tests.
struct Catalogue {
  const Task& base;
  const Setting& setting;
  bool quick;
  std::vector<ForceTest> tests = {};

  double force() const { return base.force; }
  /// Duration for which a force is constant [s].
  double hold() const { return quick ? 1.0 : 2.0; }

  /// Returns a task in which the tool presses at one point for `duration` [s].
  Task still(double duration) const {
    Task task = base;
    task.path.kind = PathKind::Points;
    task.path.points = {Eigen::Vector2d::Zero()};
    task.polish_duration = duration;
    return task;
  }

  void add_steps();
  void add_ramp();
  void add_sines();
  void add_impacts();
  void add_pushes();
  void add_edges();
  void add_curved();
  void add_motion();
};

void Catalogue::add_steps() {
  const double low = 0.5 * force(), high = force(), up = 1.0, down = up + hold();
  Task task = still(down + hold());
  task.force = low;
  task.force_profile = {.kind = ForceProfile::Kind::Steps, .points = {{up, high}, {down, low}}};
  const double wait = hold();
  const auto measure = [=](const RunResult& result) {
    const ForceSignal signal = signal_on_path(task, result);
    Measured figures;
    for (const bool rises : {true, false}) {
      const double at = rises ? up : down;
      const StepFigures step = step_figures(signal, rises ? low : high, rises ? high : low,
                                            {.at = at, .until = at + wait - (rises ? 0.5 : 0.05)});
      const std::string test = rises ? "step up" : "step down";
      figures.push_back({test, "overshoot", percent * step.overshoot});
      figures.push_back({test, "rise_time", milli * step.rise_time});
      figures.push_back({test, "delay", milli * step.delay});
      figures.push_back({test, "settling_time", milli * step.settling_time});
      figures.push_back({test, "steady_error", step.steady_error});
    }
    return figures;
  };
  tests.push_back({"step",
                   "step from " + number(low) + " to " + number(high) + " N, and back after " +
                       number(wait) + " s, at one point",
                   task, measure, true});
}

void Catalogue::add_ramp() {
  const double low = 0.5 * force(), high = force(), begin = 1.0, end = begin + 0.5;
  Task task = still(end + 0.5);
  task.force = low;
  task.force_profile = {.kind = ForceProfile::Kind::Lines, .points = {{begin, low}, {end, high}}};
  const auto measure = [=](const RunResult& result) -> Measured {
    const ForceSignal signal = signal_on_path(task, result);
    const double slope = (high - low) / (end - begin);
    const double steady = begin + 0.2 * (end - begin);
    return {{"ramp", "force_rmse", rms_error(signal, begin, end)},
            {"ramp", "force_peak", peak_error(signal, begin, end)},
            {"ramp", "lag", -milli * mean_error(signal, steady, end) / slope}};
  };
  tests.push_back({"ramp",
                   "from " + number(low) + " to " + number(high) + " N in " + number(end - begin) +
                       " s, at one point",
                   task, measure});
}

void Catalogue::add_sines() {
  const std::vector<double> frequencies =
      quick ? std::vector<double>{2.0, 8.0}
            : std::vector<double>{1.0, 2.0, 4.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0};
  const double amplitude = force() / 6.0;
  for (const double frequency : frequencies) {
    // Evaluates whole periods: at least three, and at least 1 s. The preceding periods, at least
    // 0.5 s and one period, are left for settling.
    const double settled = (std::ceil(0.5 * frequency) + 1.0) / frequency;
    const double periods = std::max(3.0, std::ceil(frequency));
    const double end = settled + periods / frequency;
    Task task = still(end + 0.1);
    task.force_profile = {
        .kind = ForceProfile::Kind::Sine, .amplitude = amplitude, .frequency = frequency};
    const std::string test = "sine " + number(frequency) + " Hz";
    const auto measure = [=](const RunResult& result) -> Measured {
      const ForceSignal signal = signal_on_path(task, result);
      const auto [first, count] = signal.rows(settled, end);
      const SineFit fit =
          fit_sine(signal.time.segment(first, count), signal.raw.segment(first, count), frequency);
      return {{test, "gain", 20.0 * std::log10(fit.amplitude / amplitude)},
              {test, "phase", fit.phase / degree},
              {test, "distortion", fit.residual},
              {test, "without_contact", milli * contact_losses(signal, settled, end).time}};
    };
    ForceTest one{test, "", task, measure};
    one.frequency = frequency;
    if (frequency == frequencies.front())
      one.meaning = "amplitude of " + number(amplitude) + " N about " + number(force()) +
                    " N, one run for each frequency, at one point";
    tests.push_back(std::move(one));
  }
}

void Catalogue::add_impacts() {
  for (const double speed :
       quick ? std::vector<double>{0.03} : std::vector<double>{0.03, 0.06, 0.12}) {
    Task task = still(1.0);
    task.approach_speed = speed;
    const std::string test = "impact at " + number(milli * speed) + " mm/s";
    const auto measure = [=](const RunResult& result) -> Measured {
      const Trace::Column touches = result.trace.column("in_contact");
      Eigen::Index row = 0;
      while (row < touches.size() && touches[row] == 0.0) ++row;
      if (row == touches.size()) return {};
      const ForceSignal signal = signal_since(result, result.trace.column("time")[row]);
      const double end = path_length(signal);
      const auto [first, count] = signal.rows(0.0, 0.05);
      const ContactLosses losses = contact_losses(signal, 0.0, end);
      return {{test, "impact_peak", signal.raw.segment(first, count).maxCoeff()},
              {test, "impact_mean", signal.force.segment(first, count).maxCoeff()},
              {test, "settling_time", milli * settling_time(signal, 0.0, end, 0.05 * task.force)},
              {test, "rebounds", static_cast<double>(losses.count)},
              {test, "without_contact", milli * losses.time}};
    };
    tests.push_back({test,
                     "contact at " + number(milli * speed) + " mm/s; then the force rises to " +
                         number(force()) + " N within " + number(task.ramp_duration) + " s",
                     task, measure});
  }
}

void Catalogue::add_pushes() {
  // Start of the push, counted from contact, and duration of the push [s].
  constexpr double start = 3.5, duration = 1.0;
  for (const bool along : {true, false}) {
    Task task = still(start + 2.0 * duration);
    const double size = force() / 3.0;
    task.disturbances.pushes = {{start, duration, size * setting.surface_axes.col(along ? 2 : 0)}};
    const std::string test = along ? "push along the normal" : "push across";
    const auto measure = [=](const RunResult& result) -> Measured {
      const ForceSignal signal = signal_on_path(task, result);
      const double begin = start - path_begin(result), end = begin + duration;
      const double last = std::min(end + duration, path_length(signal));
      if (begin < 0.0) return {};
      return {{test, "force_peak", peak_error(signal, begin, last)},
              {test, "recovery_time", milli * settling_time(signal, begin, end, 0.05 * task.force)},
              {test, "release_time", milli * settling_time(signal, end, last, 0.05 * task.force)},
              {test, "position_peak", milli * farthest_off(result, begin, last)}};
    };
    tests.push_back({test,
                     number(size) + " N on the tool for " + number(duration) + " s, " +
                         (along ? "away from the surface" : "along the surface's first tangent"),
                     task, measure, along});
  }
}

void Catalogue::add_edges() {
  // Slope of the surface behind the edge [deg], positions of the edge and of the end of the path
  // [m], speed [m/s].
  constexpr double slope = 10.0, edge = 0.03, end = 0.06, speed = 0.05;
  for (const bool rises : {false, true}) {
    Task task = base;
    task.path.kind = PathKind::Points;
    task.path.points = {{end, 0.0}};
    task.path.speed = speed;
    // Peak speed is 1.875 times mean speed, see Path.
    task.polish_duration = end / speed * 1.875 + 1.0;
    task.disturbances.surface_shape = SurfaceShape{
        .kind = SurfaceShape::Kind::Ridge, .edge = edge, .slope = slope * degree, .hollow = rises};
    const std::string test = rises ? "edge that rises" : "edge that falls";
    const auto measure = [=](const RunResult& result) -> Measured {
      const ForceSignal signal = signal_on_path(task, result);
      const Trace& trace = result.trace;
      const Eigen::Vector3d tangent = result.setting.surface_axes.col(0);
      const Eigen::VectorXd u =
          along(trace, "tool", tangent).array() - tangent.dot(result.setting.p_center);
      const double begin = path_begin(result);
      // In a valley, the tip already touches both planes before its centre reaches the edge.
      const double met = edge - (rises ? task.tip_radius * std::tan(0.5 * slope * degree) : 0.0);
      Eigen::Index row = 0;
      while (row < u.size() && !(trace.column("time")[row] > begin && u[row] >= met)) ++row;
      if (row == u.size()) return {};
      const double at = trace.column("time")[row] - begin;
      const double last = std::min(at + 1.0, path_length(signal));
      const ContactLosses losses = contact_losses(signal, at, last);
      return {{test, "force_peak", peak_error(signal, at - 0.02, last)},
              {test, "recovery_time", milli * settling_time(signal, at, last, 0.05 * task.force)},
              {test, "rebounds", static_cast<double>(losses.count)},
              {test, "without_contact", milli * losses.time}};
    };
    tests.push_back({test,
                     "at " + number(milli * speed) + " mm/s over an edge behind which the plane " +
                         (rises ? "rises" : "falls") + " by " + number(slope) +
                         " degrees; the controller assumes a plane",
                     task, measure, true});
  }
}

void Catalogue::add_curved() {
  constexpr double radius = 0.4;
  for (const bool known : {true, false}) {
    Task task = base;
    task.path = {.kind = PathKind::Circle,
                 .radius = quick ? 0.02 : 0.05,
                 .rate = 1.0,
                 .start_up = quick ? 0.5 : 2.0};
    task.polish_duration = quick ? 1.5 : 8.3;
    const SurfaceShape ball{.kind = SurfaceShape::Kind::Sphere, .radius = radius};
    if (known)
      task.shape = ball;
    else
      task.disturbances.surface_shape = ball;
    const std::string test = known ? "curved, known" : "curved, unknown";
    const auto measure = [=](const RunResult& result) -> Measured {
      if (!result.metrics) return {};
      const Metrics& metrics = *result.metrics;
      return {{test, "force_rmse", metrics.force_rmse},
              {test, "force_peak", metrics.force_peak},
              {test, "position_rmse", milli * metrics.position_rmse},
              {test, "normal_error", metrics.normal_error / degree}};
    };
    tests.push_back({test,
                     "a circle of " + number(milli * task.path.radius) +
                         " mm at 1 rad/s on a sphere of radius " + number(radius) + " m" +
                         (known ? "" : "; the controller assumes a plane"),
                     task, measure});
  }
}

void Catalogue::add_motion() {
  constexpr double amplitude = 1e-3, frequency = 1.0, drift = 5e-3, start = 3.0;
  {
    Task task = still(quick ? 2.1 : 4.1);
    task.disturbances.surface_motion = {.amplitude = amplitude, .frequency = frequency};
    const double end = quick ? 2.0 : 4.0;
    const std::string test = "surface swings";
    const auto measure = [=](const RunResult& result) -> Measured {
      const ForceSignal signal = signal_on_path(task, result);
      const auto [first, count] = signal.rows(1.0, end);
      const SineFit fit =
          fit_sine(signal.time.segment(first, count), signal.raw.segment(first, count), frequency);
      const ContactLosses losses = contact_losses(signal, 1.0, end);
      return {{test, "force_rmse", rms_error(signal, 1.0, end)},
              {test, "force_peak", peak_error(signal, 1.0, end)},
              {test, "transmission", fit.amplitude / (milli * amplitude)},
              {test, "without_contact", milli * losses.time}};
    };
    tests.push_back({test,
                     "the surface oscillates by " + number(milli * amplitude) + " mm at " +
                         number(frequency) + " Hz along its normal, at one point",
                     task, measure});
  }
  Task task = still(start + 2.1);
  task.disturbances.surface_motion = {.drift = drift, .start = start};
  const std::string test = "surface drifts";
  const auto measure = [=](const RunResult& result) -> Measured {
    const ForceSignal signal = signal_on_path(task, result);
    const double begin = start - path_begin(result), last = begin + 2.0;
    if (begin < 0.0 || path_length(signal) < last) return {};
    return {{test, "force_peak", peak_error(signal, begin, last)},
            {test, "steady_error", mean_error(signal, begin + 1.0, last)},
            {test, "force_rmse", rms_error(signal, begin + 1.0, last)}};
  };
  tests.push_back({test,
                   "the surface moves towards the tool at " + number(milli * drift) +
                       " mm/s after a start time",
                   task, measure, true});
}

}  // namespace

const std::vector<ForceFigure>& force_figures() {
  static const std::vector<ForceFigure> all{
      {"overshoot", "%", "largest overshoot beyond the new force, as a fraction of the step"},
      {"rise_time", "ms",
       "time from the last force below 10 % of the step to the first force above 90 %"},
      {"delay", "ms",
       "time from the step of the target until the force covers half of it; negative with preview"},
      {"settling_time", "ms",
       "time from the step until the force stays within 5 % of the step; for an impact, time from "
       "the first contact until the force error stays within 5 % of the force"},
      {"steady_error", "N",
       "mean force error over the last 0.3 s of a step; for a drift, from 1 s after its start to "
       "its end"},
      {"lag", "ms", "mean force error over the last four fifths of a ramp, divided by the slope"},
      {"bandwidth_3db", "Hz", "frequency at which the gain falls below -3 dB", true},
      {"bandwidth_90deg", "Hz", "frequency at which the phase falls below -90 degrees", true},
      {"gain", "dB",
       "amplitude of the force divided by the amplitude of the target, by least squares over whole "
       "periods"},
      {"phase", "deg", "phase of the force relative to the target"},
      {"distortion", "N", "rms of the force after its mean and fitted sine are subtracted"},
      {"impact_peak", "N", "largest force in the first 50 ms of contact, sampled every 0.5 ms"},
      {"impact_mean", "N", "largest mean force over 10 ms in the first 50 ms of contact"},
      {"rebounds", "", "number of losses of contact after the first contact, or after the edge"},
      {"without_contact", "ms",
       "total time without contact after the first contact, or after the edge"},
      {"force_peak", "N", "largest force error"},
      {"force_rmse", "N", "root mean square force error"},
      {"recovery_time", "ms",
       "time from the push or the edge until the force error stays below 5 % of the force"},
      {"release_time", "ms",
       "time from the end of the push until the force error stays below 5 % of the force"},
      {"transmission", "N/mm",
       "amplitude of the force divided by the amplitude of the surface's motion"},
      {"position_peak", "mm", "largest distance from the target perpendicular to the normal"},
      {"position_rmse", "mm", "rms distance from the path perpendicular to the normal"},
      {"normal_error", "deg", "rms angle between the true and the assumed or estimated normal"}};
  return all;
}

std::vector<ForceTest> force_catalogue(const Task& task, const Setting& setting, bool quick) {
  Catalogue catalogue{task, setting, quick};
  catalogue.add_steps();
  catalogue.add_ramp();
  catalogue.add_sines();
  catalogue.add_impacts();
  catalogue.add_pushes();
  catalogue.add_edges();
  catalogue.add_curved();
  catalogue.add_motion();
  return std::move(catalogue.tests);
}

}  // namespace burnish::polishing
