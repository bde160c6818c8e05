// Fills the columns of a page from the trace of a run.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/to_size.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "report/foot_rows.hpp"
#include "report/moving_mean.hpp"
#include "report/run_page.hpp"
#include "report/trace_curves.hpp"

namespace burnish {
namespace {

/// Number of page columns except the columns of joints, and number of envelopes except those of
/// torques.
constexpr int plain_columns = 30, plain_envelopes = 7;
/// Number of columns of a standing robot, except those of its supports.
constexpr int standing_columns = 9;
/// Width of the moving mean of the force [s].
constexpr double mean_over = 0.010;

/// Returns every `stride`th row and the last row.
std::vector<int> rows_of(const Trace& trace, int stride) {
  std::vector<int> rows;
  for (int row = 0; row < trace.rows(); row += stride) rows.push_back(row);
  if (!rows.empty() && rows.back() + 1 != trace.rows()) rows.push_back(trace.rows() - 1);
  return rows;
}

/// Adds signals of a trace to the columns of a page.
class PageFiller {
 public:
  PageFiller(RunPage& page, const Trace& trace, std::vector<int> rows)
      : page_(page), trace_(trace), rows_(std::move(rows)) {}

  Eigen::VectorXd chosen(const Eigen::VectorXd& all) const { return all(rows_); }
  void add(const std::string& name, const char* unit, const Eigen::VectorXd& all) {
    add_chosen(name, unit, chosen(all));
  }
  /// Adds a column with values at the rows of the page.
  void add_chosen(const std::string& name, const char* unit, const Eigen::VectorXd& values) {
    page_.columns.push_back({name, unit, values});
  }
  const std::vector<int>& rows() const { return rows_; }
  /// Adds a column with its minimum and maximum between the rows.
  void add_with_envelope(const std::string& name, const char* unit, const Eigen::VectorXd& all) {
    add(name, unit, all);
    PageEnvelope envelope{name, chosen(all), chosen(all)};
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const auto samples = all.segment(rows_[i - 1] + 1, rows_[i] - rows_[i - 1]);
      envelope.lower[static_cast<Eigen::Index>(i)] = samples.minCoeff();
      envelope.upper[static_cast<Eigen::Index>(i)] = samples.maxCoeff();
    }
    page_.envelopes.push_back(std::move(envelope));
  }
  /// Copies the column `from` of the trace to the column `name` of the page.
  void copy(const std::string& name, const std::string& from) {
    const int index = trace_.index(from);
    add(name, trace_.columns()[to_size(index)].unit.c_str(), trace_.column(index));
  }
  /// Returns the component of the vector `what` along a direction in world axes.
  Eigen::VectorXd along(const std::string& what, const Eigen::Vector3d& direction) const {
    return burnish::along(trace_, what, direction);
  }
  /// Returns the component of the vector `what` along the unit vector `of`, in every row.
  Eigen::VectorXd along_rows(const std::string& what, const std::string& of) const {
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(trace_.rows());
    for (const char* axis : {"_x_world", "_y_world", "_z_world"})
      sum += trace_.column(what + axis).array() * trace_.column(of + axis).array();
    return sum.matrix();
  }

 private:
  RunPage& page_;
  const Trace& trace_;
  std::vector<int> rows_;
};

void add_forces(PageFiller& fill, const RunPage& page, const Trace& trace) {
  fill.copy("force_target", "target_force");
  if (page.tool_frame.empty()) return;
  const Eigen::Matrix3d& axes = page.surface.true_axes;
  const auto pressing = [&](const char* what) { return fill.along_rows(what, "surface_normal"); };
  const Eigen::VectorXd force = pressing("tool_force");
  const auto time = trace.column("time");
  const double dt = trace.rows() > 1 ? time[1] - time[0] : 1.0;
  const int width = std::max(1, static_cast<int>(std::lround(mean_over / dt)));
  fill.add_with_envelope("force_normal", "N", force);
  fill.add("force_normal_mean", "N", moving_mean(force, width));
  fill.add_with_envelope("force_estimated", "N", pressing("estimated_force"));
  fill.add_with_envelope("force_measured", "N", pressing("measured_force"));
  fill.add("force_t1", "N", fill.along("tool_force", axes.col(0)));
  fill.add("force_t2", "N", fill.along("tool_force", axes.col(1)));
}

/// Returns the placement, in the first row, of a surface that the robot carries. Returns the
/// identity for other surfaces.
Eigen::Isometry3d surface_at_start(const Trace& trace) {
  Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
  if (!trace.has("surface_rx_world") || trace.rows() == 0) return start;
  const int at = trace.index("surface_x_world"), turn = trace.index("surface_rx_world");
  const Eigen::Vector3d turned(trace.at(0, turn), trace.at(0, turn + 1), trace.at(0, turn + 2));
  start.translation() << trace.at(0, at), trace.at(0, at + 1), trace.at(0, at + 2);
  if (const double angle = turned.norm(); angle > 0.0)
    start.linear() = Eigen::AngleAxisd(angle, turned / angle).toRotationMatrix();
  return start;
}

/// Positions in the plane of the path at the rows of the page. They are positions of the tip's
/// centre or, on a curved surface, of the contact point. For a surface that the robot carries,
/// positions are relative to the surface, which is drawn at its initial placement.
class Places {
 public:
  Places(const RunPage& page, const Trace& trace)
      : page_(page), start_(surface_at_start(trace)), seen_(seen_from_surface(trace, room_)) {}

  void add(PageFiller& fill, const std::string& what, const std::string& name) const {
    const int at = seen_.index(what + "_x_world");
    const std::vector<int>& rows = fill.rows();
    Eigen::MatrixXd places(rows.size(), 2);
    for (Eigen::Index i = 0; i < places.rows(); ++i) {
      const int row = rows[to_size(i)];
      places.row(i) = in_plane({seen_.at(row, at), seen_.at(row, at + 1), seen_.at(row, at + 2)});
    }
    fill.add_chosen(name + "_u", "m", places.col(0));
    fill.add_chosen(name + "_w", "m", places.col(1));
  }

 private:
  Eigen::Vector2d in_plane(const Eigen::Vector3d& p_seen) const {
    Eigen::Vector3d p = start_ * p_seen;
    if (page_.surface.nominal) p -= page_.tip_radius * page_.surface.nominal->at(p).normal;
    return page_.surface.axes.leftCols<2>().transpose() * (p - page_.path_origin_world);
  }

  const RunPage& page_;
  Eigen::Isometry3d start_;
  Trace room_ = {};
  const Trace& seen_;
};

void add_motion(PageFiller& fill, const RunPage& page, const Trace& trace) {
  for (const char* axis : {"x", "y", "z"})
    fill.copy(std::string("tool_") + axis, std::string("tool_") + axis + "_world");
  const Places places(page, trace);
  places.add(fill, "tool", "path");
  places.add(fill, "target", "target");
  fill.add_with_envelope("path_error", "m", off_target(trace));
  fill.add_with_envelope(
      "normal_error", "rad",
      fill.along_rows("estimated_normal", "surface_normal").array().min(1.0).max(-1.0).acos());
  const auto turned = [&](const char* name) { return trace.column(name).array().square(); };
  fill.add_with_envelope(
      "tool_turned", "rad",
      (turned("tool_rx_start") + turned("tool_ry_start") + turned("tool_rz_start")).sqrt());
}

/// Adds the true and the estimated normal, unless they always equal the normal of the surface's
/// axes.
void add_normals(PageFiller& fill, const RunPage& page, const Trace& trace) {
  const auto add = [&](const std::string& name, const Eigen::Vector3d& usual) {
    const char* const axes[] = {"_x", "_y", "_z"};
    const auto column = [&](int i) { return trace.column(name + axes[i] + "_world"); };
    double max_change = 0.0;
    for (int i = 0; i < 3; ++i)
      if (trace.rows() > 0)
        max_change = std::max(max_change, (column(i).array() - usual[i]).abs().maxCoeff());
    if (!(max_change > 1e-6)) return;
    for (int i = 0; i < 3; ++i) fill.add(name + axes[i], "-", column(i));
  };
  add("surface_normal", page.surface.true_axes.col(2));
  add("estimated_normal", page.surface.axes.col(2));
}

void add_joints(PageFiller& fill, const Model& model, const Trace& trace) {
  for (int k = 0; k < model.nq; ++k) fill.copy("q_" + model.q_name(k), "q_" + model.q_name(k));
  for (int k = 0; k < model.nv; ++k) fill.copy("v_" + model.v_name(k), "v_" + model.v_name(k));
  for (int k = 0; k < model.nv; ++k) {
    const int from = trace.index("tau_applied_" + model.v_name(k));
    fill.add_with_envelope("tau_" + model.v_name(k), trace.columns()[to_size(from)].unit.c_str(),
                           trace.column(from));
  }
  for (int k = 0; k < model.nv; ++k)
    fill.copy("tau_command_" + model.v_name(k), "tau_command_" + model.v_name(k));
}

/// Adds the loads of the supports, the centre of mass and the momentum of a standing robot.
void add_standing(PageFiller& fill, const RunPage& page, const Trace& trace) {
  if (page.supports.empty()) return;
  StateRows states(trace, page.plant_model.value_or(page.robot.model));
  const RigidBody& body = states.body();
  std::vector<FootRows> feet;
  for (const TouchSpec& support : page.supports) feet.emplace_back(trace, body, support);
  const std::vector<int>& rows = fill.rows();
  const auto count = static_cast<Eigen::Index>(rows.size());
  // NaN marks rows without a valid state, and friction and pressure of feet without a load.
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Index columns = standing_columns + 3 * static_cast<Eigen::Index>(feet.size());
  Eigen::MatrixXd values = Eigen::MatrixXd::Constant(count, columns, none);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int row = rows[to_size(i)];
    if (!is_usable(states.look(row))) break;
    values.row(i).head<standing_columns>() << body.com().transpose(),
        body.centroidal_momentum().transpose();
    Eigen::Index column = standing_columns;
    for (const FootRows& foot : feet) {
      const FootLoad load = foot.load(row, foot.placement(body));
      values(i, column) = load.normal;
      if (load.normal >= min_pressure_load) {
        values(i, column + 1) = foot.friction_used(load);
        if (foot.support().is_rectangle()) values(i, column + 2) = foot.margin(load);
      }
      column += 3;
    }
  }
  const char* const names[standing_columns] = {"com_x",
                                               "com_y",
                                               "com_z",
                                               "momentum_x",
                                               "momentum_y",
                                               "momentum_z",
                                               "angular_momentum_x",
                                               "angular_momentum_y",
                                               "angular_momentum_z"};
  const char* const units[] = {"m", "kg m/s", "kg m^2/s"};
  for (Eigen::Index k = 0; k < standing_columns; ++k)
    fill.add_chosen(names[k], units[k / 3], values.col(k));
  Eigen::Index column = standing_columns;
  for (const TouchSpec& support : page.supports) {
    const std::string name = "support_" + support.frame + "_";
    for (const char* entry : {"fx", "fy", "fz", "mx", "my", "mz"})
      fill.copy(name + entry, name + entry);
    fill.add_chosen(name + "load", "N", values.col(column));
    fill.add_chosen(name + "friction_used", "-", values.col(column + 1));
    if (support.is_rectangle())
      fill.add_chosen(name + "pressure_margin", "m", values.col(column + 2));
    column += 3;
  }
}

/// Adds the columns about active constraints, violations and clipped torques, unless all are zero.
void add_limits(PageFiller& fill, const Trace& trace) {
  const char* const names[] = {"active_constraints", "constraint_violation",
                               "constraints_infeasible", "clipped_torques"};
  if (std::all_of(std::begin(names), std::end(names),
                  [&](const char* name) { return (trace.column(name).array() == 0.0).all(); }))
    return;
  fill.add_with_envelope("active_constraints", "-", trace.column("active_constraints"));
  for (const char* name : {"constraint_violation", "constraints_infeasible", "clipped_torques"})
    fill.copy(name, name);
}

/// Prefix of the columns of a trace with the signals of the controller (ClosedLoop).
constexpr const char* signal_prefix = "signal_";
/// Largest number of signals with one unit on a page; a plot has seven colours.
constexpr std::size_t max_signals = 7;

/// Returns the signals that a page shows: all signals of a unit, or those with the largest absolute
/// values.
std::vector<int> shown_signals(const Trace& trace) {
  std::map<std::string, std::vector<int>> of_unit;
  for (std::size_t i = 0; i < trace.columns().size(); ++i)
    if (trace.columns()[i].name.starts_with(signal_prefix))
      of_unit[trace.columns()[i].unit].push_back(static_cast<int>(i));
  const auto peak = [&](int column) {
    double largest = 0.0;  // stays 0 if all values are NaN
    for (const double value : trace.column(column))
      largest = std::max(largest, std::isfinite(value) ? std::abs(value) : 0.0);
    return largest;
  };
  std::vector<int> shown;
  for (auto& [unit, columns] : of_unit) {
    if (columns.size() > max_signals) {
      std::map<int, double> peaks;
      for (const int column : columns) peaks[column] = peak(column);
      std::stable_sort(columns.begin(), columns.end(),
                       [&](int a, int b) { return peaks[a] > peaks[b]; });
      columns.resize(max_signals);
    }
    shown.insert(shown.end(), columns.begin(), columns.end());
  }
  return shown;
}

/// Adds the normal force and its target of each further tool, as signals. The columns of these
/// tools begin with "tool_<frame>".
void add_further_tools(PageFiller& fill, const Trace& trace) {
  const std::string begin = "tool_", end = "_target_force";
  for (const TraceColumn& column : trace.columns()) {
    if (!column.name.starts_with(begin) || !column.name.ends_with(end)) continue;
    const std::string tool = column.name.substr(0, column.name.size() - end.size());
    const std::string frame = tool.substr(begin.size());
    fill.add(signal_prefix + ("force_" + frame), "N",
             fill.along_rows(tool + "_force", tool + "_surface_normal"));
    fill.copy(signal_prefix + ("target_force_" + frame), column.name);
  }
}

std::vector<PagePhase> phases_of(const Trace& trace, const std::vector<std::string>& names) {
  const auto name_of = [&](double phase) {
    const auto place = to_size(std::max(0.0, phase));
    return place < names.size() ? names[place] : std::to_string(place);
  };
  const auto time = trace.column("time"), phase = trace.column("phase");
  std::vector<PagePhase> phases;
  for (int row = 0; row < trace.rows(); ++row) {
    const bool same = row > 0 && phase[row] == phase[row - 1];
    if (!same) phases.push_back({name_of(phase[row]), time[row], 0.0});
    phases.back().end = time[row];
    if (!same && phases.size() > 1) phases[phases.size() - 2].end = time[row];
  }
  return phases;
}

/// Adds all plans, or the fastest and the slowest plan of each group of consecutive plans, such
/// that there are about `max_plans` entries.
void add_solver(PageSolver& solver, const Trace& trace, int max_plans) {
  const auto tick = trace.column("tick"), seconds = trace.column("solve_time");
  std::vector<int> plans;
  for (int row = 0; row < trace.rows(); ++row)
    if (tick[row] != 0.0 && seconds[row] > 0.0) plans.push_back(row);
  const auto missed = trace.column("missed_deadline");
  std::vector<int> kept;
  std::vector<double> late;
  const std::size_t group =
      plans.size() <= to_size(max_plans) ? 1 : 2 * plans.size() / max_plans + 1;
  for (std::size_t begin = 0; begin < plans.size(); begin += group) {
    const auto first = plans.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last =
        plans.begin() + static_cast<std::ptrdiff_t>(std::min(begin + group, plans.size()));
    const auto faster = [&](int a, int b) { return seconds[a] < seconds[b]; };
    const auto [low, high] = std::minmax_element(first, last, faster);
    const bool is_late = std::any_of(first, last, [&](int row) { return missed[row] != 0.0; });
    for (const int row : {std::min(*low, *high), std::max(*low, *high)}) {
      if (!kept.empty() && kept.back() == row) continue;
      kept.push_back(row);
      late.push_back(is_late && row == *high ? 1.0 : 0.0);
    }
  }
  const Eigen::VectorXd time = trace.column("time"), iterations = trace.column("iterations");
  solver.time = time(kept);
  solver.solve_ms = 1e3 * Eigen::VectorXd(seconds)(kept);
  solver.iterations = iterations(kept);
  solver.missed =
      Eigen::Map<const Eigen::VectorXd>(late.data(), static_cast<Eigen::Index>(late.size()));
}

}  // namespace

int page_stride(const Trace& trace, const Model& model, int record_every, const PageSize& size) {
  int columns = plain_columns + model.nq + 3 * model.nv + 2 * (plain_envelopes + model.nv);
  const auto of_supports =
      std::count_if(trace.columns().begin(), trace.columns().end(),
                    [](const TraceColumn& column) { return column.name.starts_with("support_"); });
  columns += static_cast<int>(shown_signals(trace).size());
  if (of_supports > 0) columns += standing_columns + static_cast<int>(3 * of_supports / 2);
  constexpr double bytes_per_entry = 4.0 * 4.0 / 3.0;
  const double rows = std::clamp(size.max_megabytes * 1e6 / (columns * bytes_per_entry), 100.0,
                                 static_cast<double>(std::max(100, size.max_rows)));
  const int every = std::max(1, record_every);
  const double multiple = std::ceil(trace.rows() / (rows * every));
  return every * std::max(1, static_cast<int>(multiple));
}

void add_trace(RunPage& page, const Trace& trace, int record_every, const PageSize& size) {
  const Model& model = page.robot.model;
  const int stride = page_stride(trace, model, record_every, size);
  PageFiller fill(page, trace, rows_of(trace, stride));
  page.columns.clear();
  page.envelopes.clear();
  page.time = fill.chosen(trace.column("time"));
  page.duration = trace.rows() == 0 ? 0.0 : trace.at(trace.rows() - 1, trace.index("time"));
  fill.copy("phase", "phase");
  add_forces(fill, page, trace);
  if (!page.tool_frame.empty()) {
    fill.copy("in_contact", "in_contact");
    add_motion(fill, page, trace);
    add_normals(fill, page, trace);
  }
  add_joints(fill, model, trace);
  add_standing(fill, page, trace);
  add_limits(fill, trace);
  add_further_tools(fill, trace);
  for (const int column : shown_signals(trace)) {
    const std::string& name = trace.columns()[to_size(column)].name;
    fill.copy(name, name);
  }
  page.phases = phases_of(trace, page.phase_names);
  PageSolver solver = page.solver.value_or(PageSolver{});
  add_solver(solver, trace, size.max_plans);
  if (solver.time.size() > 0) {
    page.solver = std::move(solver);
  } else {
    page.solver.reset();
  }
}

}  // namespace burnish
