// The floating base of a robot on its feet although its inertial unit goes wrong or falls silent:
// then the feet alone tell it. See docs/state_estimation.md.
#pragma once

#include <memory>

#include "burnish/estimate/base_estimator.hpp"

namespace burnish {

/// What tells where the base is.
enum class BaseSource {
  Filter,  ///< the unit and the feet: BaseEstimator
  Feet,    ///< the feet alone: the unit is silent or wrong
  None,    ///< nothing: too few feet stand, and the unit does not count
};

/// A BaseEstimator whose unit is watched. While feet stand that say more than where the unit is
/// (two soles, three balls), and stand to each other as they did, they tell how the unit turned and
/// where it went. What differs from the unit's own readings by more than UnitWatchOptions is the
/// unit's fault, unless gyroscope and accelerometer agree that the robot tips over its feet.
///
/// From then on the feet alone tell the base (one sole, or three balls that do not lie on a line):
/// they stay where they stood before the fault, from up to half a second ago. A unit that has
/// agreed with them for `back_after` counts again. With too few feet the base stays where it was.
///
/// Ticks allocate nothing and throw nothing.
class GuardedBase {
 public:
  using Feet = BaseEstimator::Feet;

  /// Throws Error as BaseEstimator does.
  GuardedBase(const Model& model, const BaseEstimatorOptions& options);
  ~GuardedBase();
  GuardedBase(GuardedBase&&) noexcept;
  GuardedBase& operator=(GuardedBase&&) noexcept;

  /// As BaseEstimator::reset(); the unit counts.
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;

  /// As BaseEstimator::update(); without a reading `imu` is null, one that is not finite is none.
  /// `loads`: N, one per foot, or empty where they are not known; of two feet that contradict each
  /// other the one with less is taken to slip. A gap of up to `silent_after` is answered with
  /// WrongSize (no reading) or NotFinite (one that is not finite), changes nothing and is bridged
  /// by the reading after it, whose dt has the gap in it.
  Status update(const ImuReading* imu, const ConstVectorRef& q, const ConstVectorRef& v,
                Feet standing, const ConstVectorRef& loads, double dt) noexcept;

  const Eigen::VectorXd& q() const;  ///< nq, with the joints as they were read
  const Eigen::VectorXd& v() const;  ///< nv, likewise
  /// As the base and the joints were last told: foot -> world.
  Eigen::Matrix3d foot_rotation(int foot) const;
  BaseSource source() const;
  double lost_for() const;  ///< s since the source is None; else 0
  int takeovers() const;    ///< how often the unit was given up since reset()
  /// Of the filter's own; while it is not the source it stands still.
  const BaseEstimator& filter() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
