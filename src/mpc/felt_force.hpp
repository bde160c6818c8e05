// The force at the tool where no sensor measures it: from torques, positions and velocities, and
// from what they say while nothing touches.
#pragma once

#include "mpc/measurement_gate.hpp"
#include "mpc/tool_motion.hpp"

namespace burnish {

/// Of M a + b = tau + d + J^T f an observer tells d + J^T f. What it tells in the air is d, which
/// is kept from the moment on that something touches; the force is then what fits the rest best,
/// min |J^T f - rest|, and what does not fit is part of d.
class FeltForce {
 public:
  explicit FeltForce(const MpcSpec& spec);

  void reset() noexcept;
  /// acted: nv, torques that are believed to act; free: the stage holds no contact. What cannot be
  /// evaluated changes nothing.
  void update(const MeasurementGate& gate, const Eigen::VectorXd& acted, bool free) noexcept;

  /// TorqueErrorObserver::set_payload.
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)observer_.set_payload(frame, payload);
  }
  const Eigen::Vector3d& force_world() const { return force_; }        ///< N
  const Eigen::VectorXd& model_error() const { return model_error_; }  ///< d, nv, Nm (N)
  double bandwidth() const { return observer_.bandwidth(); }           ///< rad/s, of the observer

 private:
  TorqueErrorObserver observer_;
  double touch_;  ///< N, above which what stands in the air is no model error
  ToolMotion motion_;
  Eigen::VectorXd air_, rest_, model_error_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  double since_ = 0.0;  ///< s that were learnt from
};

}  // namespace burnish
