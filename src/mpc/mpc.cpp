#include "burnish/mpc/mpc.hpp"

#include <algorithm>
#include <utility>

#include "mpc/mpc_impl.hpp"

namespace burnish {

MpcController::MpcController(MpcSpec spec) : impl_(std::make_unique<Impl>(std::move(spec))) {}
MpcController::~MpcController() = default;

int MpcController::nv() const { return impl_->problem.layout().nv; }
std::optional<std::vector<TouchSensor>> MpcController::touches() const {
  return touch_sensors(impl_->spec);
}
std::vector<std::string> MpcController::tools() const {
  std::vector<std::string> frames;
  for (const ToolSpec& tool : impl_->spec.tools) frames.push_back(tool.frame);
  return frames;
}
std::vector<TraceColumn> MpcController::signals() const { return impl_->signals(); }
void MpcController::write_signals(std::span<double> values) const noexcept {
  impl_->write_signals(values);
}
void MpcController::reset() noexcept { impl_->reset(); }
const Command& MpcController::tick(const Measurement& measurement) noexcept {
  return impl_->tick(measurement);
}
double MpcController::payload_mass() const noexcept { return impl_->payload_mass(); }
Status MpcController::set_payload(std::string_view frame, const InertiaSpec& payload) {
  return impl_->set_payload(frame, payload);
}
const FaultReport& MpcController::fault() const { return impl_->fault.report; }
std::exception_ptr MpcController::take_exception() noexcept {
  return std::exchange(impl_->thrown, nullptr);
}
const LinearFeedback& MpcController::feedback() const { return impl_->policy.feedback(); }
const Eigen::VectorXd& MpcController::torque_error() const { return impl_->error.torque_error(); }
const Eigen::VectorXd& MpcController::support_friction() const { return impl_->grip.friction(); }
const Eigen::VectorXd& MpcController::force_error() const { return impl_->error.force_error(); }
const Schedule& MpcController::schedule() const { return impl_->schedule; }
double MpcController::plan_age() const { return impl_->gate.now() - impl_->policy.measured(); }
const Problem& MpcController::problem() const { return impl_->problem; }
MatrixView MpcController::plan() const { return impl_->solver.xs(); }
const DdpSolver& MpcController::solver() const { return impl_->solver; }
std::vector<double> MpcController::plan_costs(int knot) {
  const MatrixView xs = impl_->solver.xs(), us = impl_->solver.us();
  if (knot < 0 || knot > impl_->problem.knots())
    throw Error("plan_costs: knot " + std::to_string(knot) + " does not exist; wanted 0 to " +
                std::to_string(impl_->problem.knots()));
  // The last knot does not have a control; the control of the previous knot is passed.
  const int control = std::min<int>(knot, static_cast<int>(us.rows()) - 1);
  return impl_->problem.term_costs(knot, xs.row(knot).data(), us.row(control).data());
}

}  // namespace burnish
