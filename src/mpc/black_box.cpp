#include "mpc/black_box.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {

/// Returns the start of the names of a tool's columns; empty for the first tool.
std::string prefix_of(const std::vector<ToolSpec>& tools, std::size_t tool) {
  return tool == 0 ? "" : "tool_" + tools[tool].frame + "_";
}

std::vector<TraceColumn> history_columns(const Model& model, const std::vector<ToolSpec>& tools) {
  std::vector<TraceColumn> columns{
      {"time", "s"}, {"schedule_time", "s"}, {"phase", "-"}, {"fault", "-"}};
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const std::string name = i == 0 ? "tool" : "tool_" + tools[i].frame;
    for (const char* axis : {"x", "y", "z"})
      columns.push_back({name + "_force_" + axis + "_world", "N"});
    columns.push_back({prefix_of(tools, i) + "estimated_force_normal", "N"});
  }
  for (std::size_t i = 0; i < std::max<std::size_t>(1, tools.size()); ++i)
    columns.push_back({prefix_of(tools, i) + "target_force", "N"});
  columns.insert(columns.end(), {{"solve_time", "s"}, {"status", "-"}});
  for (const Joint& joint : model.joints)
    for (int i = 0; i < joint.nq; ++i)
      columns.push_back({"q_" + model.q_name(joint.q_index + i), unit_of_q(joint.kind, i)});
  const auto add = [&](const char* prefix, const char* turning, const char* sliding) {
    for (int k = 0; k < model.nv; ++k)
      columns.push_back({prefix + model.v_name(k), unit_of_v(model, k, turning, sliding)});
  };
  add("v_", "rad/s", "m/s");
  add("tau_measured_", "Nm", "N");
  add("tau_command_", "Nm", "N");
  return columns;
}

}  // namespace

BlackBox::BlackBox(const Model& model, const std::vector<ToolSpec>& tools, double tick_period,
                   FaultLatch& latch) {
  const int rows = static_cast<int>(std::max(1L, std::lround(1.0 / tick_period)));
  Trace& trace = latch.report.last_second;
  trace = Trace(history_columns(model, tools), rows);
  rows_ = RowMatrix::Zero(rows, static_cast<Eigen::Index>(trace.columns().size()));
}

void BlackBox::record(const MeasurementGate& gate, double schedule_time, const Command& command,
                      FaultLatch& latch) noexcept {
  const Measurement& m = gate.last();
  FaultReport& report = latch.report;
  const bool frozen = report.last_second.rows() > 0;
  if (frozen) return;
  auto row = rows_.row(count_ % rows_.rows());
  ++count_;
  Eigen::Index column = 0;
  const auto put = [&](double value) { row[column++] = value; };
  const auto put_all = [&](const auto& values) {
    row.segment(column, values.size()) = values.transpose();
    column += values.size();
  };
  put(gate.now());
  put(schedule_time);
  put(static_cast<double>(command.phase));
  put(static_cast<double>(report.kind));
  const Eigen::Matrix3Xd& forces_world = gate.tool_forces_world();
  for (Eigen::Index i = 0; i < forces_world.cols(); ++i) {
    const ToolCommand& tool = command.tools[to_size(i)];
    put_all(forces_world.col(i));
    put(tool.force_estimate_world.dot(tool.normal_world));
  }
  for (const ToolCommand& tool : command.tools) put(tool.target_force);
  put(command.solve_time);
  put(static_cast<double>(command.status));
  put_all(m.q);
  put_all(m.v);
  put_all(m.tau);
  put_all(command.tau);
  if (!latch.is_set()) return;
  const long count = std::min<long>(count_, rows_.rows());
  for (long i = count_ - count; i < count_; ++i) {
    double* const out = report.last_second.add_row();
    if (out != nullptr) std::copy_n(rows_.row(i % rows_.rows()).data(), rows_.cols(), out);
  }
}

}  // namespace burnish
