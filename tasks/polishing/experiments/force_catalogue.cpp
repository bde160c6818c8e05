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

/// What is shown in ms, mm, % and degrees.
constexpr double milli = 1e3, percent = 1e2;

/// The force of a run along the surface's true normal, over the s since `begin` of the trace, which
/// ends where it leaves the path.
ForceSignal signal_since(const RunResult& result, double begin) {
  const Trace& trace = result.trace;
  const Trace::Column time = trace.column("time"), phase = trace.column("phase");
  const Eigen::VectorXd raw = along_normal(trace, "tool_force");
  const double dt = trace.rows() > 1 ? time[1] - time[0] : 1.0;
  const Eigen::VectorXd mean = moving_mean(raw, samples_in(MetricsSpec{}.average, dt));
  Eigen::Index first = 0, end = trace.rows();
  while (first < end && time[first] < begin - 1e-9) ++first;
  while (end > first && phase[end - 1] > static_cast<double>(Phase::Track)) --end;
  // Means at the end reach into the retreat.
  end = std::max(first, end - samples_in(MetricsSpec{}.average, dt));
  const Eigen::Index count = end - first;
  return {.time = time.segment(first, count).array() - begin,
          .force = mean.segment(first, count),
          .raw = raw.segment(first, count),
          .target = trace.column("target_force").segment(first, count),
          .touches = trace.column("in_contact").segment(first, count)};
}

/// s of the trace, when the path began; the end of the trace if it did not.
double path_begin(const RunResult& result) {
  const Trace& trace = result.trace;
  const auto [first, end] = rows_of_phase(trace, static_cast<double>(Phase::Track));
  return trace.column("time")[std::min<Eigen::Index>(first, trace.rows() - 1)];
}

/// On the path, with the task's own force in place of what the controller took for it.
ForceSignal signal_on_path(const Task& task, const RunResult& result) {
  ForceSignal signal = signal_since(result, path_begin(result));
  for (Eigen::Index i = 0; i < signal.time.size(); ++i)
    signal.target[i] = task.force_profile.at(task.force, signal.time[i]);
  return signal;
}

/// s since the path began.
double path_length(const ForceSignal& signal) {
  return signal.time.size() > 0 ? signal.time[signal.time.size() - 1] : 0.0;
}

/// Largest distance from the target across the normal in a window, m.
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

/// Puts the runs of the catalogue together.
struct Catalogue {
  const Task& base;
  const Setting& setting;
  bool quick;
  std::vector<ForceTest> tests = {};

  double force() const { return base.force; }
  double hold() const { return quick ? 1.0 : 2.0; }  ///< s at a force

  /// Pressing at one place for a while.
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
                   "from " + number(low) + " to " + number(high) + " N at once, and back after " +
                       number(wait) + " s, at one place",
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
                       " s, at one place",
                   task, measure});
}

void Catalogue::add_sines() {
  const std::vector<double> frequencies =
      quick ? std::vector<double>{2.0, 8.0}
            : std::vector<double>{1.0, 2.0, 4.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0};
  const double amplitude = force() / 6.0;
  for (const double frequency : frequencies) {
    // Settled after half a second and a period; over whole periods of a second at least.
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
      one.meaning = number(amplitude) + " N about " + number(force()) +
                    " N, one run for each frequency, at one place";
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
                     "touched at that speed; then the force rises to " + number(force()) +
                         " N within " + number(task.ramp_duration) + " s",
                     task, measure});
  }
}

void Catalogue::add_pushes() {
  constexpr double start = 3.5, duration = 1.0;  // s of the plant: all press by then
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
                         (along ? "off the surface" : "along the surface's first tangent"),
                     task, measure, along});
  }
}

void Catalogue::add_edges() {
  constexpr double slope = 10.0, edge = 0.03, end = 0.06, speed = 0.05;  // degrees, m, m, m/s
  for (const bool rises : {false, true}) {
    Task task = base;
    task.path.kind = PathKind::Points;
    task.path.points = {{end, 0.0}};
    task.path.speed = speed;
    task.polish_duration = end / speed * 1.875 + 1.0;  // of Path's blend
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
      // A tip lies on both planes of a valley before its middle is over the edge.
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
                         " degrees; the controller knows a plane",
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
                         (known ? "" : "; the controller knows a plane"),
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
                     number(milli * amplitude) + " mm at " + number(frequency) +
                         " Hz along its normal, at one place",
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
                   "towards the tool at " + number(milli * drift) + " mm/s from one moment on",
                   task, measure, true});
}

}  // namespace

const std::vector<ForceFigure>& force_figures() {
  static const std::vector<ForceFigure> all{
      {"overshoot", "%", "farthest beyond the new force, of the step"},
      {"rise_time", "ms", "from the last time under 10 % of the step to the first over 90 %"},
      {"delay", "ms", "from the step to half of it; below zero where it was foreseen"},
      {"settling_time", "ms",
       "from the step until the force stays within 5 % of the step; of an impact from the first "
       "contact until it stays within 5 % of the force of what is wanted"},
      {"steady_error", "N",
       "mean error over the last 0.3 s of a step; of a drift from 1 s after its begin on"},
      {"lag", "ms", "mean error over the ramp without its first fifth, by its slope"},
      {"bandwidth_3db", "Hz", "where the amplitude falls below -3 dB", true},
      {"bandwidth_90deg", "Hz", "where the phase falls below -90 degrees", true},
      {"gain", "dB",
       "amplitude of the force by the wanted one, by least squares over whole periods"},
      {"phase", "deg", "of the force against the wanted one"},
      {"distortion", "N", "rms of what is left of the force without mean and sine"},
      {"impact_peak", "N", "largest force of any 0.5 ms in the 50 ms from the first contact on"},
      {"impact_mean", "N", "largest mean over 10 ms there"},
      {"rebounds", "", "losses of contact after the first one, or after the edge"},
      {"without_contact", "ms", "time that they lasted"},
      {"force_peak", "N", "largest error"},
      {"force_rmse", "N", "root mean square error"},
      {"recovery_time", "ms",
       "from where it begins, the push or the edge, until the error stays below 5 % of the force"},
      {"release_time", "ms", "the same from the push's end on"},
      {"transmission", "N/mm", "amplitude of the force by that of the surface's motion"},
      {"position_peak", "mm", "farthest from the place across the normal"},
      {"position_rmse", "mm", "rms distance from the path across the normal"},
      {"normal_error", "deg", "rms angle between the surface's normal and what is believed"}};
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
