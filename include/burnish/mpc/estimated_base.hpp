// What stands between sensing and the controller of a robot on its feet: a measurement whose base
// is estimated rather than known.
#pragma once

#include <memory>

#include "burnish/estimate/base_estimator.hpp"
#include "burnish/estimate/foot_contacts.hpp"
#include "burnish/estimate/guarded_base.hpp"
#include "burnish/mpc/controller.hpp"

namespace burnish {

/// Which feet stand is told by their sensors, where a measurement has any
/// (Measurement::support_wrenches, a column for each of the estimator's feet, in their order, and
/// behind them those of what else the robot leans on), and by joint torques through the dynamics
/// (FootForces) where not; the base then by GuardedBase: by a BaseEstimator, and by the feet alone
/// where the unit is silent or wrong. Ticks throw nothing, and allocate nothing but what the first
/// of such further columns takes.
///
/// A payload that a controller is given later (MpcController::set_payload) does not reach the foot
/// forces that are computed here, so each of the two rejects the other. Put a payload that is known
/// from the start into the model: with_payload().
class EstimatedBase {
 public:
  /// Throws Error as BaseEstimator and FootContacts do.
  EstimatedBase(const Model& model, const BaseEstimatorOptions& estimator,
                const FootContactOptions& contacts = {});
  ~EstimatedBase();
  EstimatedBase(EstimatedBase&&) noexcept;
  EstimatedBase& operator=(EstimatedBase&&) noexcept;

  /// Starts at a state of the whole robot, q (nq) and v (nv), on these feet: all of them unless
  /// said. WrongSize, NotFinite or NotNormalized, which change nothing.
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v,
               BaseEstimator::Feet standing = ~BaseEstimator::Feet{0}) noexcept;

  /// The measurement with the base's entries of q and v replaced by their estimates. The first one
  /// after reset() only starts the clock. What cannot be used (no reading of the unit for a moment,
  /// a time that stands still, see status()) leaves the base where it was.
  const Measurement& update(const Measurement& measured) noexcept;

  /// Of the last update: WrongSize without a reading of the unit for a moment or with fewer
  /// supports than feet, NotFinite for numbers that are none and a time that does not go on.
  Status status() const;
  const GuardedBase& base() const;
  const BaseEstimator& estimator() const;  ///< of the base; it stands still while the feet tell it
  const FootContacts& contacts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
