#include "burnish/mpc/model_error.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"

namespace burnish {

struct TorqueErrorObserver::Impl {
  Impl(const Model& model, const std::string& tool, const ModelErrorOptions& given)
      : options(given),
        dynamics(model),
        body(model),
        frame(body.frame(tool)),
        velocity(Eigen::VectorXd::Zero(model.nv)),
        error(Eigen::VectorXd::Zero(model.nv)),
        total(Eigen::VectorXd::Zero(model.nv)),
        innovation(Eigen::VectorXd::Zero(model.nv)) {
    if (!(given.bandwidth > 0.0) || !std::isfinite(given.bandwidth))
      throw Error("model error: a bandwidth of " + number(given.bandwidth) +
                  " rad/s; wanted a positive number");
    if (!(given.limit > 0.0))
      throw Error("model error: a limit of " + number(given.limit) + "; wanted a positive number");
  }

  ModelErrorOptions options;
  ContactDynamics dynamics;
  RigidBody body;
  int frame;
  FrameDerivatives derivatives;
  bool started = false;
  Eigen::VectorXd velocity, error, total, innovation;
};

TorqueErrorObserver::TorqueErrorObserver(const Model& model, const std::string& tool,
                                         const ModelErrorOptions& options)
    : impl_(std::make_unique<Impl>(model, tool, options)) {
  // Resized on first use: here, rather than in a tick.
  impl_->body.frame_derivatives(impl_->frame, Reference::centered(), impl_->derivatives);
}
TorqueErrorObserver::~TorqueErrorObserver() = default;
TorqueErrorObserver::TorqueErrorObserver(TorqueErrorObserver&&) noexcept = default;
TorqueErrorObserver& TorqueErrorObserver::operator=(TorqueErrorObserver&&) noexcept = default;

void TorqueErrorObserver::reset() noexcept {
  impl_->started = false;
  impl_->error.setZero();
}

const Eigen::VectorXd& TorqueErrorObserver::torque_error() const { return impl_->error; }

Status TorqueErrorObserver::update(const ConstVectorRef& q, const ConstVectorRef& v,
                                   const ConstVectorRef& tau, const Eigen::Vector3d& force_world,
                                   double dt) noexcept {
  Impl& d = *impl_;
  if (tau.size() != d.total.size()) return Status::WrongSize;
  if (!tau.allFinite() || !force_world.allFinite() || !std::isfinite(dt)) return Status::NotFinite;
  Status status = d.body.update(q, v);
  if (status > Status::NotConverged) return status;
  if (!d.started) {
    d.velocity = v;
    d.started = true;
    return status;
  }
  if (!(dt > 0.0)) return status;
  d.body.frame_derivatives(d.frame, Reference::centered(), d.derivatives);
  d.total = tau + d.error;
  d.total.noalias() += d.derivatives.jacobian.topRows(3).transpose() * force_world;
  status = d.dynamics.forward(q, v, d.total);
  if (status > Status::NotConverged) return status;
  const double pole = std::exp(-d.options.bandwidth * dt);
  d.velocity += dt * d.dynamics.a();
  d.innovation = v - d.velocity;
  d.velocity += (1.0 - pole * pole) * d.innovation;
  d.innovation *= (1.0 - pole) * (1.0 - pole) / dt;
  d.error.noalias() += d.dynamics.mass_matrix() * d.innovation;
  d.error = d.error.cwiseMax(-d.options.limit).cwiseMin(d.options.limit);
  return status;
}

}  // namespace burnish
