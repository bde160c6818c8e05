#include <algorithm>
#include <limits>
#include <map>

#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"
#include "contact/force_column.hpp"
#include "files/here.hpp"
#include "model/joint_entries.hpp"
#include "record/solution.hpp"

namespace burnish {
namespace {

constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

std::string contact_name(const ContactSpec& contact) {
  return contact.name.empty() ? contact.tool : contact.name;
}

std::vector<int> held(const ContactSpec& contact) {
  std::vector<int> directions;
  for (int d = 0; d < 6; ++d)
    if (contact.directions.has(d)) directions.push_back(d);
  return directions;
}

void add_state_columns(const Problem& problem, std::vector<TraceColumn>& columns) {
  const Model& model = problem.model();
  const StateLayout& layout = problem.layout();
  for (const Joint& joint : model.joints)
    for (int i = 0; i < joint.nq; ++i)
      columns.push_back({"q_" + model.q_name(joint.q_index + i), unit_of_q(joint.kind, i)});
  const auto per_entry = [&](const std::string& prefix, int k, const char* linear,
                             const char* angular) {
    const Joint& joint = model.joints[to_size(model.joint_of_v[to_size(k)])];
    const int entry = k - joint.v_index;
    const bool is_linear = entry < sliding_entries(joint.kind);
    columns.push_back({prefix + model.v_name(k), is_linear ? linear : angular});
  };
  for (int k = 0; k < model.nv; ++k) per_entry("v_", k, "m/s", "rad/s");
  for (const int k : layout.actuated) per_entry("tau_", k, "N", "Nm");
  for (const int k : layout.actuated) per_entry("u_", k, "N", "Nm");
}

std::vector<TraceColumn> columns_of(const Problem& problem) {
  std::vector<TraceColumn> columns{{"time", "s"}, {"stage", "-"}};
  add_state_columns(problem, columns);
  for (const ContactSpec& contact : problem.spec().contacts)
    for (const int d : held(contact)) {
      const char* unit = d < 3 ? "N" : "Nm";
      columns.push_back({force_column(contact, d), unit});
      columns.push_back({force_column(contact, d) + "_target", unit});
    }
  for (const std::string& frame : followed(problem.spec()).frames)
    for (const char* what : {"", "_target"})
      for (const char axis : {'x', 'y', 'z'})
        columns.push_back({frame + "_" + axis + "_world" + what, "m"});
  for (const std::string& frame : followed(problem.spec()).frames)
    columns.push_back({frame + "_distance_from_target", "m"});
  return columns;
}

/// Writer of one row of a trace.
struct RowWriter {
  Problem& problem;
  Trace& trace;
  int knot;
  Eigen::VectorXd x, u;
  double* row;

  double& at(const std::string& column) const { return row[trace.index(column)]; }
  const std::vector<CostTerm>& terms() const {
    const auto stage = to_size(problem.stage_of(knot));
    const ProblemSpec& spec = problem.spec();
    return stage < spec.stages.size() ? spec.stages[stage].costs : spec.terminal;
  }
  static Eigen::VectorXd value(const Signal& signal, int rows, double time) {
    if (signal.empty()) return Eigen::VectorXd::Zero(rows);
    Eigen::VectorXd result(signal.size());
    signal.at(time, result);
    return result.size() == 1 ? Eigen::VectorXd::Constant(rows, result[0]) : result;
  }

  void state() {
    const StateLayout& layout = problem.layout();
    const bool last = knot == problem.knots();
    row[0] = problem.time_of(knot);
    row[1] = problem.stage_of(knot);
    int column = 2;
    for (int i = 0; i < layout.nq + layout.nv; ++i) row[column++] = x[i];
    for (int i = 0; i < layout.nu; ++i)
      row[column++] = layout.filtered > 0 ? x[layout.nq + layout.nv + i]
                      : last              ? not_available
                                          : u[i];
    for (int i = 0; i < layout.nu; ++i) row[column++] = last ? not_available : u[i];
  }

  void forces() {
    const std::vector<std::string> names = problem.force_names(knot);
    const Eigen::VectorXd forces = problem.forces(knot, x, u);
    std::map<std::string, double> by_name;
    for (Eigen::Index i = 0; i < forces.size(); ++i) by_name[names[to_size(i)]] = forces[i];
    const bool has_forces = knot < problem.knots() || forces.size() > 0;
    for (const ContactSpec& contact : problem.spec().contacts)
      for (const int d : held(contact)) {
        const std::string name =
            contact_name(contact) + "/" + std::string(direction_names[to_size(d)]);
        const auto found = by_name.find(name);
        // The force of a contact that is not active is 0. Forces may be unknown at the last knot.
        at(force_column(contact, d)) = found != by_name.end() ? found->second
                                       : has_forces           ? 0.0
                                                              : not_available;
        at(force_column(contact, d) + "_target") = not_available;
      }
    for (const CostTerm& term : terms()) {
      const auto* wanted = std::get_if<residual::ContactForce>(&term.residual);
      if (wanted == nullptr || wanted->reference || term.weight == 0.0) continue;
      for (const ContactSpec& contact : problem.spec().contacts) {
        if (contact_name(contact) != wanted->contact) continue;
        const Eigen::VectorXd target = value(wanted->target, contact.directions.count(), row[0]);
        int i = 0;
        for (const int d : held(contact)) at(force_column(contact, d) + "_target") = target[i++];
      }
    }
  }

  /// Target position of a frame, and the frame's distance from this target along rows with weight.
  struct Aim {
    Eigen::Vector3d target = Eigen::Vector3d::Constant(not_available);  // in world axes [m]
    double distance = not_available;                                    // along weighted rows [m]
  };
  Aim aim_of(const std::string& frame, const Eigen::Vector3d& p) const {
    Aim aim;
    for (const CostTerm& term : terms()) {
      if (const auto* r = std::get_if<residual::FramePosition>(&term.residual)) {
        if (r->frame != frame) continue;
        const files::PositionAxes axes = files::position_axes(
            problem.model(), x.head(problem.model().nq), frame, r->reference.at(row[0]));
        aim.target = axes.numbers * Eigen::Vector3d(value(r->target, 3, row[0]));
        Eigen::Vector3d error = axes.rows.transpose() * (p - aim.target);
        for (Eigen::Index i = 0; i < term.weights.size(); ++i)
          if (term.weights[i] == 0.0) error[i] = 0.0;
        aim.distance = error.norm();
      } else if (const auto* s = std::get_if<residual::FramePlacement>(&term.residual)) {
        if (s->frame != frame) continue;
        aim.target = value(s->target, 7, row[0]).head(3);
        aim.distance = (p - aim.target).norm();
      }
    }
    return aim;
  }

  void frames() {
    const Model& model = problem.model();
    for (const std::string& frame : followed(problem.spec()).frames) {
      const Eigen::Vector3d p = frame_placement(model, x.head(model.nq), frame).translation();
      const Aim aim = aim_of(frame, p);
      for (int i = 0; i < 3; ++i) {
        const std::string column = frame + "_" + "xyz"[i] + "_world";
        at(column) = p[i];
        at(column + "_target") = aim.target[i];
      }
      at(frame + "_distance_from_target") = aim.distance;
    }
  }
};

}  // namespace

PlotSignals followed(const ProblemSpec& spec) {
  PlotSignals result;
  const auto add = [&](const std::string& frame) {
    if (std::find(result.frames.begin(), result.frames.end(), frame) == result.frames.end())
      result.frames.push_back(frame);
  };
  const auto look = [&](const std::vector<CostTerm>& terms) {
    for (const CostTerm& term : terms) {
      if (const auto* r = std::get_if<residual::FramePosition>(&term.residual)) add(r->frame);
      if (const auto* r = std::get_if<residual::FramePlacement>(&term.residual)) add(r->frame);
    }
  };
  const auto look_at_limits = [&](const std::vector<Constraint>& constraints) {
    for (const Constraint& constraint : constraints)
      if (const auto* r = std::get_if<residual::FramePosition>(&constraint.residual)) add(r->frame);
  };
  for (const Stage& stage : spec.stages) look(stage.costs);
  look(spec.terminal);
  for (const Stage& stage : spec.stages) look_at_limits(stage.constraints);
  look_at_limits(spec.terminal_constraints);
  for (const ContactSpec& contact : spec.contacts)
    for (const int d : held(contact)) result.forces.push_back(force_column(contact, d));
  return result;
}

Trace solution_trace(Problem& problem, const MatrixView& xs, const MatrixView& us) {
  const int knots = problem.knots();
  Trace trace(columns_of(problem), knots + 1);
  for (int k = 0; k <= knots; ++k) {
    const int nu = problem.controls(k);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(problem.max_controls());
    if (nu > 0) u.head(nu) = us.row(k).head(nu).transpose();
    RowWriter writer{problem, trace, k, xs.row(k).transpose(), u, trace.add_row()};
    writer.state();
    writer.forces();
    writer.frames();
  }
  return trace;
}

}  // namespace burnish
