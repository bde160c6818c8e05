// Grip of the supports that are in contact in every stage: detection of slip, and the coefficient
// of friction that plans use.
#pragma once

#include <string>
#include <vector>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/estimate/slip.hpp"

namespace burnish {

/// Support of a robot, as plans describe it.
struct GripSpec {
  std::string name;       ///< Name of the contact.
  std::string frame;      ///< Frame of the robot that the support holds.
  int sensor;             ///< Column of `wrenches` in update(); -1: no sensor.
  double friction;        ///< Coefficient of the friction cone; infinite: no cone.
  double half_x, half_y;  ///< Half lengths of the sole's sides [m]; 0: point foot.
};

class SupportGrip {
 public:
  SupportGrip(const Model& model, const std::vector<GripSpec>& supports,
              const SlipOptions& options);

  void reset() noexcept;
  /// Updates the estimates with a measurement, `dt` [s] after the previous one. `body`: kinematics
  /// at the measurement. `wrenches`: measured wrenches on supports, as in Measurement::wrenches.
  void update(const RigidBody& body, const Wrenches& wrenches, double dt) noexcept;

  /// Returns the coefficient of friction that plans use, per support; infinite if the support has
  /// no friction cone.
  const Eigen::VectorXd& friction() const { return friction_; }
  /// Support with its recent sliding.
  struct Support : GripSpec {
    int index;             ///< Index of the frame.
    Eigen::Vector3d slid;  ///< Recent displacement along the ground, in world axes [m].
    double speed;          ///< Sliding speed along the ground [m/s].
    double distance;       ///< Length of `slid` [m].
  };
  const std::vector<Support>& supports() const { return supports_; }

 private:
  void follow(Support& support, const RigidBody& body, double dt) const noexcept;
  double required_friction(const Support& support, const Eigen::Matrix<double, 6, 1>& wrench,
                           const Eigen::Matrix3d& R, double load) const noexcept;
  double updated_friction(const Support& support, const RigidBody& body, const Wrenches& wrenches,
                          double dt, double friction) const noexcept;

  SlipOptions options_;
  Eigen::Vector3d up_;
  Reference centered_ = Reference::centered();
  std::vector<Support> supports_;
  Eigen::VectorXd friction_;
};

}  // namespace burnish
