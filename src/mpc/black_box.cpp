#include "mpc/black_box.hpp"

#include <algorithm>
#include <cmath>

#include "model/joint_entries.hpp"

namespace burnish {
namespace {

std::vector<TraceColumn> history_columns(const Model& model) {
  std::vector<TraceColumn> columns{{"time", "s"},
                                   {"schedule_time", "s"},
                                   {"phase", "-"},
                                   {"fault", "-"},
                                   {"tool_force_x_world", "N"},
                                   {"tool_force_y_world", "N"},
                                   {"tool_force_z_world", "N"},
                                   {"estimated_force_normal", "N"},
                                   {"target_force", "N"},
                                   {"solve_time", "s"},
                                   {"status", "-"}};
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

BlackBox::BlackBox(const Model& model, double tick_period, FaultLatch& latch) {
  const int rows = static_cast<int>(std::max(1L, std::lround(1.0 / tick_period)));
  Trace& trace = latch.report.last_second;
  trace = Trace(history_columns(model), rows);
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
  const Eigen::Index nq = m.q.size(), nv = m.v.size();
  row[0] = gate.now();
  row[1] = schedule_time;
  row[2] = static_cast<double>(command.phase);
  row[3] = static_cast<double>(report.kind);
  row.segment<3>(4) = gate.tool_force_world().transpose();
  row[7] = command.force_estimate_world.dot(command.normal_world);
  row[8] = command.target_force;
  row[9] = command.solve_time;
  row[10] = static_cast<double>(command.status);
  row.segment(11, nq) = m.q.transpose();
  row.segment(11 + nq, nv) = m.v.transpose();
  row.segment(11 + nq + nv, nv) = m.tau.transpose();
  row.segment(11 + nq + 2 * nv, nv) = command.tau.transpose();
  if (!latch.is_set()) return;
  const long count = std::min<long>(count_, rows_.rows());
  for (long i = count_ - count; i < count_; ++i) {
    double* const out = report.last_second.add_row();
    if (out != nullptr) std::copy_n(rows_.row(i % rows_.rows()).data(), rows_.cols(), out);
  }
}

}  // namespace burnish
