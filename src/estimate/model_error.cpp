#include "burnish/estimate/model_error.hpp"

#include "burnish/contact/loops.hpp"
#include "estimate/error_observer.hpp"

namespace burnish {

struct TorqueErrorObserver::Impl {
  Impl(RobotState robot, ErrorObserver errors)
      : state(std::move(robot)),
        observer(std::move(errors)),
        forces_world(3, static_cast<Eigen::Index>(state.tools().size())) {}

  RobotState state;
  ErrorObserver observer;
  Eigen::Matrix3Xd forces_world;  ///< Force on the tool, one column; no column without a tool.
};

TorqueErrorObserver::TorqueErrorObserver(const Model& model, const std::string& tool,
                                         const ModelErrorOptions& options,
                                         const std::vector<ContactSpec>& supports,
                                         const std::vector<std::string>& measured,
                                         const std::string& base) {
  std::vector<ToolFrames> tools;
  if (!tool.empty()) tools.push_back({tool, base});
  RobotState state(model, with_loops(model, supports), tools);
  ErrorObserver observer(model, options, state, supports, measured);
  impl_ = std::make_unique<Impl>(std::move(state), std::move(observer));
}
TorqueErrorObserver::~TorqueErrorObserver() = default;
TorqueErrorObserver::TorqueErrorObserver(TorqueErrorObserver&&) noexcept = default;
TorqueErrorObserver& TorqueErrorObserver::operator=(TorqueErrorObserver&&) noexcept = default;

void TorqueErrorObserver::reset() noexcept { impl_->observer.reset(); }
Status TorqueErrorObserver::set_payload(std::string_view frame, const InertiaSpec& payload) {
  return impl_->state.set_payload(frame, payload);
}
const Eigen::VectorXd& TorqueErrorObserver::torque_error() const {
  return impl_->observer.torque_error();
}
double TorqueErrorObserver::bandwidth() const { return impl_->observer.bandwidth(); }

Status TorqueErrorObserver::update(const ConstVectorRef& q, const ConstVectorRef& v,
                                   const ConstVectorRef& tau, const Eigen::Vector3d& force_world,
                                   double dt, const Wrenches& supports) noexcept {
  const Status status = impl_->state.update(q, v);
  if (!is_usable(status)) return status;
  impl_->forces_world.colwise() = force_world;
  return impl_->observer.update(impl_->state, tau, impl_->forces_world, dt, supports);
}

}  // namespace burnish
