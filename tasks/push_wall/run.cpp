#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mpc/mpc.hpp"
#include "pressing/closed_run.hpp"
#include "pressing/standing_terms.hpp"
#include "push_wall/limits_near.hpp"
#include "push_wall/measured.hpp"
#include "push_wall/pushing.hpp"
#include "report/moving_mean.hpp"

namespace burnish::push_wall {
namespace {

/// Returns the index of the first row that belongs to `phase` or to a later phase.
int first_row(const Trace& trace, int phase) {
  const Trace::Column phases = trace.column("phase");
  return static_cast<int>(
      std::find_if(phases.begin(), phases.end(), [&](double now) { return now >= phase; }) -
      phases.begin());
}

/// True positions and forces of hands and feet, computed from the rows of a trace.
class Replay {
 public:
  Replay(const Task& task, const RunResult& result)
      : task_(task),
        setting_(result.setting),
        trace_(result.trace),
        model_(result.setting.robot.model),
        body_(model_),
        q_(model_.nq),
        first_q_(trace_.index("q_" + model_.q_name(0))) {
    for (const std::string& hand : task.hands) hands_.push_back(body_.frame(hand));
    for (const std::string& foot : task.standing.feet) feet_.push_back(body_.frame(foot));
  }
  bool go_to(int row) {
    for (int k = 0; k < model_.nq; ++k) q_[k] = trace_.at(row, first_q_ + k);
    return is_usable(body_.update(q_, Eigen::VectorXd::Zero(model_.nv)));
  }
  Eigen::Vector3d wrench_force(const std::string& frame, int row) const {
    const int at = trace_.index("support_" + frame + "_fx");
    return {trace_.at(row, at), trace_.at(row, at + 1), trace_.at(row, at + 2)};
  }
  /// Returns the normal force of a hand [N].
  double force(std::size_t hand, int row) const {
    const Eigen::Vector3d f = wrench_force(task_.hands[hand], row);
    return (body_.placement(hands_[hand]).linear() * f).dot(setting_.wall_axes.col(2));
  }
  Eigen::Isometry3d hand(std::size_t h) const { return body_.placement(hands_[h]); }
  Eigen::Vector3d foot(std::size_t i) const { return body_.placement(feet_[i]).translation(); }
  Eigen::Vector3d com() const { return body_.com(); }
  /// Returns the offset of the centre of pressure from the middle of a sole, as a fraction of a
  /// half side: the larger fraction of x and y; 0 for point feet and small loads.
  double sole_share(std::size_t foot, int row) const {
    const std::string name = "support_" + task_.standing.feet[foot];
    const double load = trace_.at(row, trace_.index(name + "_fz"));
    if (!task_.standing.has_soles() || !(load > pressing::min_load_of(model_, task_.standing)))
      return 0.0;
    const double mx = trace_.at(row, trace_.index(name + "_mx"));
    const double my = trace_.at(row, trace_.index(name + "_my"));
    return std::max(std::abs(my) / load / task_.standing.half_x,
                    std::abs(mx) / load / task_.standing.half_y);
  }

 private:
  const Task& task_;
  const Setting& setting_;
  const Trace& trace_;
  const Model& model_;
  RigidBody body_;
  Eigen::VectorXd q_;
  int first_q_;
  std::vector<int> hands_, feet_;
};

/// Errors of the force of one hand and mean of this force, over a range of rows.
struct ForceError {
  double rmse = 0.0, peak = 0.0, mean = 0.0;
};
ForceError force_error(const Eigen::VectorXd& force, const Eigen::VectorXd& target, int begin,
                       int end) {
  const Eigen::Index size = end - begin;
  const Eigen::VectorXd error = force.segment(begin, size) - target.segment(begin, size);
  return {std::sqrt(error.squaredNorm() / static_cast<double>(size)), error.cwiseAbs().maxCoeff(),
          force.segment(begin, size).mean()};
}

/// Returns a range of rows: from `after` [s] after the start of the phase `from` to 0.02 s before
/// the start of the phase `until`.
std::pair<int, int> window(const Trace& trace, int from, double after, int until) {
  const Trace::Column time = trace.column("time");
  int begin = first_row(trace, from);
  const int rows = static_cast<int>(time.size());
  if (begin >= rows) return {0, 0};
  const double start = time[begin] + after;
  while (begin < rows && time[begin] < start) ++begin;
  int end = std::min(first_row(trace, until), rows);
  while (end > begin && time[end - 1] > time[std::min(first_row(trace, until), rows - 1)] - 0.02)
    --end;
  return {begin, end};
}

/// Returns the normal forces of both hands for all rows, averaged over 10 ms [N]. Writes slip,
/// centre of pressure and displacement into `figures`.
std::array<Eigen::VectorXd, 2> replay(const Task& task, RunResult& result, PushFigures& figures) {
  const Trace& trace = result.trace;
  const Trace::Column phase = trace.column("phase"), time = trace.column("time");
  std::array<Eigen::VectorXd, 2> forces;
  for (Eigen::VectorXd& force : forces) force = Eigen::VectorXd::Zero(time.size());
  Replay at(task, result);
  std::array<Eigen::Isometry3d, 2> contact;
  std::vector<Eigen::Vector3d> start;
  const Eigen::Vector3d n = result.setting.wall_axes.col(2);
  bool pushes = false;
  for (int row = 0; row < static_cast<int>(time.size()) && at.go_to(row); ++row) {
    for (std::size_t i = 0; i < task.standing.feet.size(); ++i) {
      if (row == 0) start.push_back(at.foot(i));
      figures.foot_slip = std::max(figures.foot_slip, (at.foot(i) - start[i]).head<2>().norm());
      if (phase[row] >= 1.0)  // after the phase `settle`
        figures.sole_share = std::max(figures.sole_share, at.sole_share(i, row));
    }
    const auto in = static_cast<int>(phase[row]);
    const bool now = in >= ramp && in <= release;
    for (std::size_t h = 0; h < 2; ++h) {
      forces[h][row] = at.force(h, row);
      if (now && !pushes) contact[h] = at.hand(h);
      if (now)
        figures.hand_slip = std::max(
            figures.hand_slip, pressing::slid(contact[h], at.hand(h), n, task.tip_radius).norm());
    }
    pushes = now;
    figures.com_displacement =
        std::max(figures.com_displacement, (result.setting.com - at.com()).dot(n));
  }
  const double dt = time.size() > 1 ? time[1] - time[0] : 1.0;
  for (Eigen::VectorXd& force : forces)
    force = moving_mean(force, std::max(1, static_cast<int>(std::lround(0.01 / dt))));
  return forces;
}

void measure_push(const Task& task, const SearchState& search_state, RunResult& result) {
  const Trace& trace = result.trace;
  const auto [begin, end] = window(trace, hold, settling, force_search);
  if (end - begin < 2) return;
  PushFigures figures;
  const std::array<Eigen::VectorXd, 2> forces = replay(task, result, figures);
  const Eigen::VectorXd target = trace.column("target_force");
  const auto [top_begin, top_end] = window(trace, top, back_duration + settling, release);
  figures.largest_force = top_end - top_begin > 1 ? 1e9 : 0.0;
  for (const Eigen::VectorXd& force : forces) {
    const ForceError held = force_error(force, target, begin, end);
    figures.force_rmse = std::max(figures.force_rmse, held.rmse);
    figures.force_peak = std::max(figures.force_peak, held.peak);
    figures.force_mean += 0.5 * held.mean;
    if (top_end - top_begin < 2) continue;
    const ForceError largest = force_error(force, target, top_begin, top_end);
    figures.largest_force = std::min(figures.largest_force, largest.mean);
    figures.largest_rmse = std::max(figures.largest_rmse, largest.rmse);
  }
  figures.search_force = std::max(0.0, search_state.reached.load());
  result.push = figures;
}

/// Returns the name of the condition that ended the search for the largest force.
std::string cause_of(const Task& task, const RunResult& result) {
  const std::string by = result.limited_by.empty() ? "" : " (" + result.limited_by + ")";
  switch (result.limit) {
    case Limit::None:
      return "nothing";
    case Limit::ForceMax:
      return "force_search.force_max of " + number(force_max(task)) + " N";
    case Limit::Statics:
      return "the statics of the posture" + by;
    case Limit::Tracking:
      return "hands with a force below the target" + by;
    case Limit::Plan:
      return "infeasible constraints of plans" + by;
    case Limit::Hand:
      return "a hand that slipped" + by;
    case Limit::Foot:
      return "a foot that slipped" + by;
  }
  return "";
}

std::string outcome_of(const Task& task, const RunResult& result, const pressing::RunEnd& end) {
  const std::string& phase = phase_names()[to_size(end.phase)];
  if (const std::string trouble = pressing::trouble_of(result, end, phase); !trouble.empty())
    return trouble;
  if (!result.push)
    return "the hold was not completed: the run ended at " + number(end.time) + " s, in phase " +
           phase;
  char text[160];
  std::snprintf(text, sizeof text,
                "pushed: rms error %.2f N at %.0f N per hand; %.1f N held, after a search up to "
                "%.1f N, which was limited by ",
                result.push->force_rmse, task.force, result.push->largest_force,
                result.push->search_force);
  return text + cause_of(task, result);
}

/// Returns the scene of the plant: `nominal` with the disturbances of the surface applied to the
/// wall.
SceneSpec with_true_wall(const Task& task, const SceneSpec& nominal) {
  SceneSpec scene = nominal;
  const SurfaceSpec wall = plant_surface(scene.touches.back().surface, task.disturbances);
  for (std::size_t i = task.standing.feet.size(); i < scene.touches.size(); ++i) {
    SurfaceSpec& surface = scene.touches[i].surface;
    surface.point = wall.point;
    surface.normal = wall.normal;
    surface.friction = wall.friction;
  }
  return scene;
}

}  // namespace

RunResult run_task(const RunSpec& spec) {
  const Task& task = spec.task;
  check_task(task);
  RunResult result;
  result.setting = spec.setting ? *spec.setting : make_setting(task);
  const Setting& setting = result.setting;
  if (spec.check_reach) refuse_out_of_reach(task, setting);
  const auto search_state = std::make_shared<SearchState>();
  MpcSpec mpc_spec = make_mpc(task, setting, search_state);
  const ProblemSpec problem = mpc_spec.problem;
  MpcController mpc(std::move(mpc_spec));
  const SceneSpec scene = with_true_wall(task, setting.scene);
  const double end = setting.release_end + task.retreat_duration;
  const double max_duration = task.standing.settle + end + pressing::patience(task.late_contact);
  pressing::ClosedRun run{.controller = mpc,
                          .period = 1.0 / task.tick_rate,
                          .model = setting.robot.model,
                          .scene = scene,
                          .disturbances = task.disturbances,
                          .q_start = setting.q_start,
                          .longest = max_duration,
                          .plant = spec.plant,
                          .standing = &task.standing,
                          .mpc = &mpc,
                          .plan_step = task.step,
                          .solver_delay = task.solver_delay + task.command_delay,
                          .plan_rate = spec.plan_rate};
  std::optional<PlanAt> last;
  run.goes_on = [&](double now, const Command&) {
    if (!last && search_state->limit != 0) last = plan_now(mpc);
    return mpc.schedule().time() < end && now < max_duration;
  };
  run.end = [end] { return end; };
  run.progress = spec.progress;
  const pressing::RunEnd ended = pressing::run_closed_loop(run, result);
  result.limit = static_cast<Limit>(search_state->limit.load());
  const int where = search_state->where;
  if (result.limit == Limit::Hand) result.limited_by = task.hands[to_size(where)];
  if (result.limit == Limit::Foot) result.limited_by = task.standing.feet[to_size(where)];
  if (result.limit == Limit::Statics) result.limited_by = make_statics(task, setting).name(where);
  if (last && where < 0 && result.limit != Limit::ForceMax)
    result.limited_by = limits_near(problem, *last);
  measure_push(task, *search_state, result);
  result.outcome = outcome_of(task, result, ended);
  result.succeeded = is_usable(result.plant_status) && result.fault.kind == FaultKind::None &&
                     !result.interrupted && result.push.has_value() && mpc.schedule().time() >= end;
  return result;
}

}  // namespace burnish::push_wall
