// Values that an MpcController publishes in traces.
#include <cmath>

#include "model/joint_entries.hpp"
#include "mpc/mpc_impl.hpp"

namespace burnish {
/// Calls see(column, value) for each signal of the controller itself. column() returns name and
/// unit.
template <class See>
void MpcController::Impl::each_signal(const See& see) const {
  const Model& model = spec.problem.model;
  if (spec.model_error.kind == ModelErrorKind::Torque)
    for (const int k : problem.layout().actuated)
      see(
          [&] {
            return TraceColumn{"torque_error_" + model.v_name(k), unit_of_v(model, k, "Nm", "N")};
          },
          error.torque_error()[k]);
  if (spec.model_error.kind == ModelErrorKind::Force)
    for (std::size_t i = 0; i < spec.tools.size(); ++i)
      see(
          [&] {
            return TraceColumn{"force_error_" + spec.tools[i].frame, "N"};
          },
          error.force_error()[static_cast<Eigen::Index>(i)]);
  for (std::size_t i = 0; i < grip.supports().size(); ++i)
    if (std::isfinite(grip.supports()[i].friction))
      see(
          [&] {
            return TraceColumn{"friction_" + grip.supports()[i].name, "-"};
          },
          grip.friction()[static_cast<Eigen::Index>(i)]);
}

std::vector<TraceColumn> MpcController::Impl::signals() const {
  std::vector<TraceColumn> columns;
  each_signal([&](const auto& column, double) { columns.push_back(column()); });
  for (TraceColumn& column : task->signals()) columns.push_back(std::move(column));
  return columns;
}

void MpcController::Impl::write_signals(std::span<double> values) const noexcept {
  std::size_t count = 0;
  each_signal([&](const auto&, double value) {
    if (count < values.size()) values[count++] = value;
  });
  if (values.size() >= count + task_signals_)
    task->write_signals(values.subspan(count, task_signals_));
}

}  // namespace burnish
