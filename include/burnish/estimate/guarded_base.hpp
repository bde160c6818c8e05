// Estimate of the floating base of a robot on its feet that tolerates faults of the inertial
// measurement unit (IMU). After a fault, the feet alone determine the base. See
// docs/state_estimation.md.
#pragma once

#include <memory>

#include "burnish/estimate/base_estimator.hpp"

namespace burnish {

/// Source of the current estimate of the floating base.
enum class BaseSource {
  Filter,  ///< BaseEstimator, which uses the IMU and the feet
  Feet,    ///< Feet alone, because the IMU is silent or faulty
  None,    ///< No source: the IMU is not used, and too few feet stand
};

/// BaseEstimator with a monitor for faults of the inertial measurement unit (IMU).
///
/// The monitor works while the standing feet overdetermine the pose of the IMU. This needs two
/// planar feet (soles) or three point feet (balls). While these feet do not move relative to each
/// other, their kinematics give the rotation and displacement of the IMU. The IMU is declared
/// faulty if its readings differ from this motion by more than UnitWatchOptions allow. No fault is
/// declared if gyroscope and accelerometer agree that the robot tips over.
///
/// After a fault, the feet alone determine the base. This needs one sole, or three balls that are
/// not on a line. The estimate assumes that each foot stands where it stood shortly before the
/// fault. Once the IMU has agreed with the feet for the time `back_after`, the IMU is used again.
/// With too few feet, the base stays at its last estimate.
///
/// Updates allocate nothing and throw nothing.
class GuardedBase {
 public:
  using Feet = BaseEstimator::Feet;

  /// Creates the estimator. Throws Error for arguments that BaseEstimator rejects.
  GuardedBase(const Model& model, const BaseEstimatorOptions& options);
  ~GuardedBase();
  GuardedBase(GuardedBase&&) noexcept;
  GuardedBase& operator=(GuardedBase&&) noexcept;

  /// Starts the estimate at `q` (nq) and `v` (nv) of the whole robot; see BaseEstimator::reset().
  /// The IMU is used again, even after a fault.
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;

  /// Updates the estimate; see BaseEstimator::update(). `imu` is null if there is no reading. A
  /// reading that is not finite counts as missing. `loads` holds the force on each foot [N]; it is
  /// empty if the forces are unknown. If two feet contradict each other, the foot with less force
  /// is assumed to slip.
  ///
  /// If readings are missing for at most `silent_after`, the call changes nothing. It returns
  /// WrongSize (no reading) or NotFinite (reading not finite). The `dt` of the next call must
  /// include the gap.
  Status update(const ImuReading* imu, const ConstVectorRef& q, const ConstVectorRef& v,
                Feet standing, const ConstVectorRef& loads, double dt) noexcept;

  const Eigen::VectorXd& q() const;  ///< Estimated base and measured joint positions, nq
  const Eigen::VectorXd& v() const;  ///< Estimated base and measured joint velocities, nv

  /// Returns the rotation matrix from a foot's axes to world axes, at the latest estimate.
  Eigen::Matrix3d foot_rotation(int foot) const;
  BaseSource source() const;
  double lost_for() const;  ///< Time since the source became None [s]; 0 with another source
  int takeovers() const;    ///< Number of times since reset() that the IMU was rejected

  /// Returns the underlying BaseEstimator. It is updated only while source() is Filter.
  const BaseEstimator& filter() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
