// Estimate of the force on each foot from joint torques and the robot's dynamics, without force
// sensors.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/estimate/base_estimator.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Observer that estimates the ground forces f on the feet from the joint torques tau. The motion
/// of the robot needs the torques M dv/dt + b. The ground forces supply the difference from tau:
///   J^T f = M dv/dt + b - tau.
/// A first-order low-pass filter of bandwidth w smooths the right-hand side. Its output is r:
///   dr/dt = w (M dv/dt + b - tau - r).
/// This is a generalized-momentum observer (De Luca, Mattone, "Actuator failure detection and
/// isolation using generalized momenta", 2003). It computes dv/dt from the velocities of two
/// consecutive updates.
///
/// The estimate f minimizes |J^T f - r| and includes moments for planar feet (soles). The norm is
/// over all entries of v, including the base and joints that move no foot.
class FootForces {
 public:
  /// Creates the observer with the low-pass `bandwidth` [rad/s]. Throws Error if a foot is unknown
  /// or fixed to the world, or if the bandwidth is not positive.
  FootForces(const Model& model, const std::vector<FootSpec>& feet, double bandwidth);
  ~FootForces();
  FootForces(FootForces&&) noexcept;
  FootForces& operator=(FootForces&&) noexcept;

  void reset() noexcept;
  /// Sets the payload that the robot carries at a frame. Returns and throws as
  /// ContactDynamics::set_payload() does.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  /// Updates the forces from the current state `q` (nq), `v` (nv) and the torques `tau` (nv) [Nm or
  /// N] of the last `dt` [s]. Entries of `tau` for the base must be zero. The first update after
  /// reset() assumes dv/dt = 0, as for a robot at rest or in steady motion.
  ///
  /// Returns Ok. Otherwise changes nothing and returns WrongSize, NotFinite (also if dt is not
  /// positive), NotNormalized, or SingularContacts. SingularContacts means that the posture does
  /// not determine the force of each foot.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                double dt) noexcept;

  const Eigen::Matrix3Xd& forces_world()
      const;  ///< Force of the ground on each foot, world axes [N]
  const Eigen::VectorXd& normal_forces()
      const;  ///< Upward component of the ground force on each foot [N]

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
