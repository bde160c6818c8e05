// The constant part of what the model gets wrong, estimated from measurements and given back to the
// model, so that wrong masses, friction and torque offsets leave no lasting error (offset-free
// model predictive control; for contact tasks: Jordana et al., "Force Feedback Model-Predictive
// Control via Online Estimation", 2024).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// What is estimated.
enum class ModelErrorKind {
  None,    ///< nothing: the paper's controller
  Torque,  ///< d in M a + b = tau + J^T f + d, a torque per joint
  Force,   ///< what the measured normal force is above the one that the model predicts
};

struct ModelErrorOptions {
  ModelErrorKind kind = ModelErrorKind::Torque;
  double bandwidth = 30.0;  ///< rad/s of the observer; positive
  double limit = 30.0;      ///< Nm (N): estimates stay within +- this
};

/// An observer of the joint velocity with the torque error as its disturbance state: with e = v -
/// v^, critically damped at the bandwidth w,
///   d(v^)/dt = M^-1 (tau + J_n^T f_n + d - b) + 2 w e,   d(d)/dt = w^2 M e.
/// Only the normal force f_n is known to it; friction along the surface is thus part of d.
class TorqueErrorObserver {
 public:
  /// `tool`: frame that the force acts at. Throws Error for an unknown frame and options out of
  /// range.
  TorqueErrorObserver(const Model& model, const std::string& tool,
                      const ModelErrorOptions& options);
  ~TorqueErrorObserver();
  TorqueErrorObserver(TorqueErrorObserver&&) noexcept;
  TorqueErrorObserver& operator=(TorqueErrorObserver&&) noexcept;

  void reset() noexcept;
  /// A measurement, dt s after the last one: q (nq), v (nv), joint torques tau (nv), and the force
  /// on the tool, world axes. A state that cannot be evaluated changes nothing. No allocation.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                const Eigen::Vector3d& force_world, double dt) noexcept;
  const Eigen::VectorXd& torque_error() const;  ///< d, nv, Nm (N)

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
