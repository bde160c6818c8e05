// Estimation of the floating base of a robot on its feet. The estimator runs between the sensors
// and the controller.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/estimate/base_estimator.hpp"
#include "burnish/estimate/foot_contacts.hpp"
#include "burnish/estimate/guarded_base.hpp"
#include "burnish/estimate/measurement.hpp"

namespace burnish {

/// Estimates the floating base of a robot on its feet. In the measurements that the controller
/// receives, the estimate replaces the base's entries of q and v.
///
/// Measurement::wrenches shows which feet are on the ground. If a foot has no column, or if its
/// force is NaN, FootForces computes the forces on all feet from the joint torques.
///
/// GuardedBase estimates the base with a BaseEstimator. While the inertial measurement unit is
/// silent or wrong, the base is estimated from the feet alone. update() does not throw, and
/// does not allocate.
///
/// Each payload that is set on the controller must also be set here. ClosedLoop::set_payload() sets
/// the payload on both. While the payload masses of controller and estimator differ, the controller
/// reports NotPhysical in Command::status and holds the robot.
class EstimatedBase {
 public:
  /// `touches`: frames of the columns of Measurement::wrenches, as Controller::touches() returns
  /// them. By default, the columns are the feet in the order of BaseEstimatorOptions::feet.
  /// Measurements without columns are valid, too. Throws Error in the same cases as the
  /// constructors of BaseEstimator and FootContacts.
  EstimatedBase(const Model& model, const BaseEstimatorOptions& estimator,
                const FootContactOptions& contacts = {},
                const std::vector<std::string>& touches = {});
  ~EstimatedBase();
  EstimatedBase(EstimatedBase&&) noexcept;
  EstimatedBase& operator=(EstimatedBase&&) noexcept;

  /// Restarts the estimate at the configuration q (nq entries) and velocity v (nv entries) of the
  /// whole robot. `standing`: the feet that are on the ground, one bit per foot; by default all
  /// feet. If the state is invalid, returns WrongSize, NotFinite or NotNormalized and changes
  /// nothing; otherwise returns Ok.
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v,
               BaseEstimator::Feet standing = ~BaseEstimator::Feet{0}) noexcept;

  /// Sets the payload that the robot carries at a frame. Does not allocate. reset() keeps the
  /// payload. Returns and throws as ContactDynamics::set_payload() does.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);

  /// Returns the measurement with the base's entries of q and v replaced by estimates. The first
  /// call after reset() only records the time. If a measurement cannot be used, the estimate of the
  /// base stays unchanged and status() returns the reason.
  const Measurement& update(const Measurement& measured) noexcept;

  /// Returns the status of the last update(). WrongSize: a vector has the wrong size, the
  /// number of columns of the wrenches differs from the number of touches, or the inertial
  /// measurement unit has been silent for a short time. NotFinite: an entry is not finite, or the
  /// time does not increase.
  Status status() const;
  const GuardedBase& base() const;
  /// Returns the filter that uses the inertial measurement unit. The filter is not updated while
  /// the base is estimated from the feet alone.
  const BaseEstimator& estimator() const;
  const FootContacts& contacts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
