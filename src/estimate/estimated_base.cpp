#include "burnish/estimate/estimated_base.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/to_size.hpp"
#include "burnish/estimate/foot_forces.hpp"
#include "dynamics/payloads.hpp"

namespace burnish {
namespace {

std::vector<std::string> frames_of_feet(const std::vector<FootSpec>& feet) {
  std::vector<std::string> frames;
  for (const FootSpec& foot : feet) frames.push_back(foot.frame);
  return frames;
}

}  // namespace

struct EstimatedBase::Impl {
  Impl(const Model& model, const BaseEstimatorOptions& options, const FootContactOptions& feet,
       const std::vector<std::string>& frames)
      : base(model, options),
        feet_count(base.filter().feet()),
        contacts(model, feet_count, feet),
        forces(model, options.feet, feet.bandwidth),
        payloads(model),
        up(-model.gravity.normalized()),
        tau(Eigen::VectorXd::Zero(model.nv)),
        normal_forces(Eigen::VectorXd::Zero(feet_count)) {
    result.q = model.q_neutral;
    result.v = result.tau = tau;
    for (const FootSpec& foot : options.feet)
      columns.push_back(std::find(frames.begin(), frames.end(), foot.frame) - frames.begin());
    touches = static_cast<Eigen::Index>(frames.size());
    result.wrenches.setZero(6, touches);
  }

  /// Returns whether a measurement contains a finite force on each foot.
  bool has_foot_forces(const Measurement& measured) const noexcept {
    return measured.wrenches.cols() == touches &&
           std::all_of(columns.begin(), columns.end(), [&](Eigen::Index column) {
             return column < touches && measured.wrenches.col(column).head<3>().allFinite();
           });
  }

  Status update_contacts(const Measurement& measured, double dt) noexcept;
  Status follow(const Measurement& measured) noexcept;

  GuardedBase base;
  int feet_count;
  Eigen::Index touches = 0;           ///< Number of columns of Measurement::wrenches.
  std::vector<Eigen::Index> columns;  ///< Wrench column of each foot; `touches`: no column.
  FootContacts contacts;
  FootForces forces;
  Payloads payloads;
  Eigen::Vector3d up;
  bool started = false;
  Status status = Status::Ok;
  double last = 0.0;    ///< Time of the last usable measurement [s].
  Eigen::VectorXd tau;  ///< Torques of the current measurement, with zero entries for the base.
  Eigen::VectorXd normal_forces;
  Measurement result;
};

EstimatedBase::EstimatedBase(const Model& model, const BaseEstimatorOptions& estimator,
                             const FootContactOptions& contacts,
                             const std::vector<std::string>& touches)
    : impl_(std::make_unique<Impl>(model, estimator, contacts,
                                   touches.empty() ? frames_of_feet(estimator.feet) : touches)) {}
EstimatedBase::~EstimatedBase() = default;
EstimatedBase::EstimatedBase(EstimatedBase&&) noexcept = default;
EstimatedBase& EstimatedBase::operator=(EstimatedBase&&) noexcept = default;

Status EstimatedBase::reset(const ConstVectorRef& q, const ConstVectorRef& v,
                            BaseEstimator::Feet standing) noexcept {
  Impl& d = *impl_;
  const Status status = d.base.reset(q, v);
  if (status != Status::Ok) return status;
  d.contacts.reset(standing);
  d.forces.reset();
  d.started = false;
  d.status = Status::Ok;
  d.result.q = q;
  d.result.v = v;
  d.result.base_lost_for = 0.0;
  return Status::Ok;
}

Status EstimatedBase::set_payload(std::string_view frame, const InertiaSpec& payload) {
  Impl& d = *impl_;
  const Status status = d.forces.set_payload(frame, payload);
  if (status != Status::Ok) return status;
  d.payloads.set(frame, payload);
  d.result.base_payload = d.payloads.mass();
  return status;
}

/// Updates the set of standing feet from measured wrenches or, without wrenches, from joint
/// torques.
Status EstimatedBase::Impl::update_contacts(const Measurement& measured, double dt) noexcept {
  if (measured.wrenches.cols() != 0 && measured.wrenches.cols() != touches)
    return Status::WrongSize;
  if (has_foot_forces(measured)) {
    for (int k = 0; k < feet_count; ++k)
      normal_forces[k] =
          up.dot(base.foot_rotation(k) * measured.wrenches.col(columns[to_size(k)]).head<3>());
    return contacts.update(normal_forces, dt);
  }
  // Uses the base estimate of the previous tick, because the estimate of this tick needs the
  // standing feet.
  if (measured.q.size() != result.q.size() || measured.v.size() != result.v.size())
    return Status::WrongSize;
  result.q.tail(result.q.size() - 7) = measured.q.tail(result.q.size() - 7);
  result.v.tail(result.v.size() - 6) = measured.v.tail(result.v.size() - 6);
  if (measured.tau.size() != tau.size()) return Status::WrongSize;
  tau = measured.tau;
  tau.head<6>().setZero();
  const Status status_of_forces = forces.update(result.q, result.v, tau, dt);
  if (status_of_forces != Status::Ok) return status_of_forces;
  return contacts.update(forces.normal_forces(), dt);
}

Status EstimatedBase::Impl::follow(const Measurement& measured) noexcept {
  if (!std::isfinite(measured.time)) return Status::NotFinite;
  if (!started) last = measured.time;
  const bool first = !started;
  started = true;
  if (first) return Status::Ok;
  // The IMU reading covers all of the time since the last usable measurement.
  const double dt = measured.time - last;
  if (!(dt > 0.0)) return Status::NotFinite;
  const BaseSource before = base.source();
  const bool waits = before == BaseSource::Filter && !measured.imu &&
                     dt <= base.filter().options().watch.silent_after;
  if (waits) return Status::WrongSize;
  const Status status_of_feet = update_contacts(measured, dt);
  if (status_of_feet != Status::Ok) return status_of_feet;
  const ImuReading* const imu = measured.imu ? &*measured.imu : nullptr;
  const Status status_of_base =
      base.update(imu, measured.q, measured.v, contacts.standing(), contacts.forces(), dt);
  if (status_of_base == Status::Ok) last = measured.time;
  // A new source of the base velocity causes a jump, which must not count as an acceleration.
  if (base.source() != before) forces.reset();
  return status_of_base;
}

const Measurement& EstimatedBase::update(const Measurement& measured) noexcept {
  Impl& d = *impl_;
  d.status = d.follow(measured);
  Measurement& result = d.result;
  result.time = measured.time;
  result.imu = measured.imu;
  if (measured.wrenches.cols() == d.touches)
    result.wrenches = measured.wrenches;
  else
    result.wrenches.setConstant(std::numeric_limits<double>::quiet_NaN());
  if (measured.tau.size() == result.tau.size()) result.tau = measured.tau;
  if (measured.q.size() == result.q.size())
    result.q.tail(result.q.size() - 7) = measured.q.tail(result.q.size() - 7);
  if (measured.v.size() == result.v.size())
    result.v.tail(result.v.size() - 6) = measured.v.tail(result.v.size() - 6);
  result.q.head<7>() = d.base.q().head<7>();
  result.v.head<6>() = d.base.v().head<6>();
  result.base_lost_for = d.base.lost_for();
  result.base_is_estimated = true;
  return result;
}

Status EstimatedBase::status() const { return impl_->status; }
const GuardedBase& EstimatedBase::base() const { return impl_->base; }
const BaseEstimator& EstimatedBase::estimator() const { return impl_->base.filter(); }
const FootContacts& EstimatedBase::contacts() const { return impl_->contacts; }

}  // namespace burnish
