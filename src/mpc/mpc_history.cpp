// The last second of an MpcController, kept for its fault report.
#include <algorithm>
#include <cmath>

#include "mpc/mpc_impl.hpp"

namespace burnish {
namespace {

/// Whether entry `entry` of a joint's v is a translation.
bool slides(JointKind kind, int entry) {
  return kind == JointKind::Prismatic || (kind == JointKind::Planar && entry < 2) ||
         (kind == JointKind::FreeFlyer && entry < 3);
}

/// Of an entry of a joint's q: quaternions, cosines and sines have none.
const char* unit_of_q(JointKind kind, int entry) {
  if (kind == JointKind::Revolute) return "rad";
  return slides(kind, entry) ? "m" : "-";
}

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
  const auto add = [&](const char* part, const char* turning, const char* sliding) {
    for (const Joint& joint : model.joints)
      for (int i = 0; i < joint.nv; ++i)
        columns.push_back(
            {part + model.v_name(joint.v_index + i), slides(joint.kind, i) ? sliding : turning});
  };
  add("v_", "rad/s", "m/s");
  add("tau_measured_", "Nm", "N");
  add("tau_command_", "Nm", "N");
  return columns;
}

}  // namespace

void MpcController::Impl::make_history() {
  const int rows = static_cast<int>(std::max(1L, std::lround(1.0 / spec.tick_period)));
  fault.last_second = Trace(history_columns(problem.model()), rows);
  history_ = RowMatrix::Zero(rows, static_cast<Eigen::Index>(fault.last_second.columns().size()));
}

void MpcController::Impl::record(double now) noexcept {
  const bool frozen = fault.last_second.rows() > 0;
  if (frozen) return;
  auto row = history_.row(history_rows_ % history_.rows());
  ++history_rows_;
  const Eigen::Index nq = q_.size(), nv = v_.size();
  row[0] = now;
  row[1] = schedule.time();
  row[2] = static_cast<double>(command_.phase);
  row[3] = static_cast<double>(fault.kind);
  row.segment<3>(4) = tool_force.transpose();
  row[7] = command_.force_estimate_world.dot(spec.normal_world);
  row[8] = command_.target_force;
  row[9] = command_.solve_time;
  row[10] = static_cast<double>(command_.status);
  row.segment(11, nq) = q_.transpose();
  row.segment(11 + nq, nv) = v_.transpose();
  row.segment(11 + nq + nv, nv) = tau_.transpose();
  row.segment(11 + nq + 2 * nv, nv) = command_.tau.transpose();
  if (fault.kind == FaultKind::None) return;
  const long count = std::min<long>(history_rows_, history_.rows());
  for (long i = history_rows_ - count; i < history_rows_; ++i) {
    double* const out = fault.last_second.add_row();
    if (out != nullptr) std::copy_n(history_.row(i % history_.rows()).data(), history_.cols(), out);
  }
}

}  // namespace burnish
