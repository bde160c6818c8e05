#include "burnish/estimate/guarded_base.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "estimate/feet_fit.hpp"
#include "estimate/foot_kinematics.hpp"
#include "estimate/unit_watch.hpp"

namespace burnish {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<char> soles_in(const BaseEstimatorOptions& options) {
  std::vector<char> result;
  for (const FootSpec& foot : options.feet) result.push_back(foot.kind == FootKind::Sole ? 1 : 0);
  return result;
}

/// Returns the weight of a sole's rotation in the fit [m/rad]: the ratio of the slip noise to the
/// rotation noise. Soles that may rotate in place thus have little influence on the estimated yaw.
double length_of(const BaseEstimatorOptions& options) {
  const double turns = std::max(options.sole_turn_noise, 1e-9);
  return std::clamp(options.slip_noise / turns, 0.05, 0.5);
}

/// Snapshot of the estimate at some time. It contains the poses of the feet, the biases, and
/// thresholds for later differences between IMU and feet.
struct Moment {
  Moment(const std::vector<char>& soles, double length) : feet(soles, length) {}
  FeetFit feet;
  Vector3d b_gyro = Vector3d::Zero(), b_accelerometer = Vector3d::Zero();
  /// Thresholds for the difference of IMU and feet in rotation [rad] and displacement [m].
  double turn_gate = 0.0, place_gate = 0.0;
  double speed_gate = 0.0;  ///< Three standard deviations of the velocity difference [m/s].
};

// Time constants, chosen by hand.

// Duration of identical readings after which the IMU counts as stuck [s].
constexpr double stuck = 0.01;
// Age at which a snapshot is replaced [s]. A fault must be detected within this time, so that the
// older snapshot was taken before the fault.
constexpr double moment_period = 0.25;

}  // namespace

struct GuardedBase::Impl {
  Impl(const Model& model, const BaseEstimatorOptions& options)
      : filter(model, options),
        watch_options(options.watch),
        kinematics(filter.kinematics()),
        watch(options.watch.window),
        older(soles_in(options), length_of(options)),
        newer(older),
        gravity(model.gravity),
        q(model.q_neutral),
        v(Eigen::VectorXd::Zero(model.nv)),
        rested(Eigen::VectorXd::Zero(filter.feet())) {}

  UnitPose last_unit() const noexcept;
  Vector3d last_velocity() const noexcept;
  void set_base(const UnitPose& at, const Vector3d& v_unit, const Vector3d& w_unit) noexcept;
  void take_moment(Moment& moment, FootSet feet, const UnitPose& unit) noexcept;
  void begin_again(FootSet standing) noexcept;
  bool feet_agree(const UnitPose& unit, FootSet feet, FootSet& worst,
                  const ConstVectorRef& loads) const noexcept;
  double encoder_place() const noexcept;
  void compare(const ImuReading& imu, double dt) noexcept;
  double gate_ratio() const noexcept;
  bool feet_rest() const noexcept;
  UnitWatch::Tips tips() const noexcept;
  ImuReading vetted_reading(const ImuReading& imu, double dt) const noexcept;
  Status follow_filter(const ImuReading* imu, const ConstVectorRef& q_read,
                       const ConstVectorRef& v_read, FootSet standing, const ConstVectorRef& loads,
                       double dt) noexcept;
  void give_up_unit(bool silent, FootSet standing) noexcept;
  void follow_feet(const ImuReading* imu, FootSet standing, const ConstVectorRef& loads,
                   double dt) noexcept;
  bool stand(FootSet standing, const ConstVectorRef& loads, double dt) noexcept;
  void take_unit_back(const Vector3d& b_gyro) noexcept;

  BaseEstimator filter;
  UnitWatchOptions watch_options;
  FootKinematics& kinematics;  ///< Kinematics that the filter uses too, computed once per reading.
  UnitWatch watch;
  /// Snapshots. `newer` is the latest. `older` has an age of `moment_period` or more, except after
  /// a start.
  Moment older, newer;
  double since_newer = 0.0;  ///< Time since `newer` [s].
  FootSet followed = 0;      ///< Feet that both snapshots contain.
  UnitPose by_feet;          ///< Pose of the IMU, computed from the feet in `older`.
  Vector3d gravity;
  Eigen::VectorXd q, v;
  BaseSource source = BaseSource::Filter;
  bool was_silent = false;  ///< True if the IMU was rejected because its readings were missing.
  double tipping = 0.0;     ///< Remaining time for which the robot counts as tipping [s].
  double lost = 0.0, agreed = 0.0;
  int takeovers = 0;
  /// Decaying offset of the reported pose from the pose that the feet give, in the world: rotation
  /// [rad] and displacement [m]. The offset avoids jumps when the source of the pose changes.
  Vector3d off_turn = Vector3d::Zero(), off_place = Vector3d::Zero();
  FootSet out = 0;         ///< Feet that contradict the other feet and are not used.
  Eigen::VectorXd rested;  ///< Time for which the feet in `out` have been at rest [s].
};

GuardedBase::GuardedBase(const Model& model, const BaseEstimatorOptions& options)
    : impl_(std::make_unique<Impl>(model, options)) {}
GuardedBase::~GuardedBase() = default;
GuardedBase::GuardedBase(GuardedBase&&) noexcept = default;
GuardedBase& GuardedBase::operator=(GuardedBase&&) noexcept = default;

Status GuardedBase::reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  Impl& d = *impl_;
  const Status status = d.filter.reset(q, v);
  if (status != Status::Ok) return status;
  d.q = q;
  d.v = v;
  d.source = BaseSource::Filter;
  d.followed = d.out = 0;
  d.watch.stop();
  d.tipping = d.lost = d.agreed = 0.0;
  d.takeovers = 0;
  d.was_silent = false;
  return Status::Ok;
}

Status GuardedBase::update(const ImuReading* imu, const ConstVectorRef& q, const ConstVectorRef& v,
                           Feet standing, const ConstVectorRef& loads, double dt) noexcept {
  Impl& d = *impl_;
  if (!(dt > 0.0) || !std::isfinite(dt)) return Status::NotFinite;
  if (loads.size() != 0 && loads.size() != d.filter.feet()) return Status::WrongSize;
  const bool says = imu != nullptr && imu->gyro.allFinite() && imu->accelerometer.allFinite();
  if (!says && d.source == BaseSource::Filter && dt <= d.watch_options.silent_after)
    return imu == nullptr ? Status::WrongSize : Status::NotFinite;
  const Status status = d.kinematics.update(q, v);
  if (status != Status::Ok) return status;
  if (d.filter.feet() < 32) standing &= foot_bit(d.filter.feet()) - 1;
  const ImuReading* const reading = says ? imu : nullptr;
  if (d.source == BaseSource::Filter) {
    const Status of_filter = d.follow_filter(reading, q, v, standing, loads, dt);
    if (d.source == BaseSource::Filter) return of_filter;
  }
  d.q.tail(d.q.size() - 7) = q.tail(d.q.size() - 7);
  d.v.tail(d.v.size() - 6) = v.tail(d.v.size() - 6);
  d.follow_feet(reading, standing, loads, dt);
  return Status::Ok;
}

/// Returns the pose of the IMU, from the last estimate of the base and the current joint readings.
UnitPose GuardedBase::Impl::last_unit() const noexcept {
  const FramePose<double>& joint = kinematics.base_joint();
  const FramePose<double>& unit = kinematics.unit_in_base();
  const Matrix3d R_base =
      to_eigen(joint.R) * Eigen::Quaterniond(q[6], q[3], q[4], q[5]).toRotationMatrix();
  const Vector3d p_base = to_eigen(joint.p) + to_eigen(joint.R) * q.head<3>();
  return {R_base * to_eigen(unit.R), p_base + R_base * to_eigen(unit.p)};
}

/// Returns the velocity of the IMU from the last estimate of the base, in world axes [m/s].
Vector3d GuardedBase::Impl::last_velocity() const noexcept {
  const FramePose<double>& unit = kinematics.unit_in_base();
  const Vector3d w_base = v.segment<3>(3);
  const Vector3d in_base = v.head<3>() + w_base.cross(to_eigen(unit.p)) +
                           to_eigen(kinematics.unit_in_base_velocity().linear);
  return to_eigen(kinematics.base_joint().R) *
         (Eigen::Quaterniond(q[6], q[3], q[4], q[5]).toRotationMatrix() * in_base);
}

/// Sets the base from pose and velocities of the IMU. `v_unit`, `w_unit`: velocity and angular
/// velocity in the axes of the IMU.
void GuardedBase::Impl::set_base(const UnitPose& at, const Vector3d& v_unit,
                                 const Vector3d& w_unit) noexcept {
  const FramePose<double>& joint = kinematics.base_joint();
  const FramePose<double>& unit = kinematics.unit_in_base();
  const Motion<double>& moves = kinematics.unit_in_base_velocity();
  const Matrix3d R_unit = to_eigen(unit.R), R_joint = to_eigen(joint.R);
  const Matrix3d R_base = at.R * R_unit.transpose();
  const Vector3d p_base = at.p - R_base * to_eigen(unit.p);
  q.head<3>() = R_joint.transpose() * (p_base - to_eigen(joint.p));
  Eigen::Quaterniond turn(Matrix3d(R_joint.transpose() * R_base));
  turn.normalize();
  const double side = turn.coeffs().dot(q.segment<4>(3)) < 0.0 ? -1.0 : 1.0;
  q.segment<4>(3) = side * turn.coeffs();
  const Vector3d w_base = R_unit * w_unit - to_eigen(moves.angular);
  v.segment<3>(3) = w_base;
  v.head<3>() = R_unit * v_unit - w_base.cross(to_eigen(unit.p)) - to_eigen(moves.linear);
}

/// Returns the standard deviation of a foot's position due to encoder noise [m]. It is also used
/// for the foot's rotation [rad], for which it is right within a factor of 2.
double GuardedBase::Impl::encoder_place() const noexcept {
  double max_square = 0.0;
  for (int k = 0; k < kinematics.feet(); ++k)
    max_square = std::max(max_square, kinematics.jacobian(k).squaredNorm());
  return filter.options().encoder_noise * std::sqrt(max_square);
}

/// Takes a snapshot. Each threshold is the value in the options plus 3 sigma. sigma^2 is the sum of
/// the variances along three axes, which noise, biases and tilt cause. If they are equal, 3 sigma
/// are about five standard deviations along one axis.
void GuardedBase::Impl::take_moment(Moment& moment, FootSet feet, const UnitPose& unit) noexcept {
  const BaseEstimatorOptions& o = filter.options();
  moment.feet.put(feet, unit, kinematics.all_seen());
  moment.b_gyro = filter.gyro_bias();
  moment.b_accelerometer = filter.accelerometer_bias();
  const Eigen::MatrixXd& P = filter.covariance();
  const double time = watch_options.window, encoder = encoder_place();
  const auto square = [](double x) { return x * x; };
  // Let theta be the error of the rotation and zeta the error of the bias. The specific force in
  // the world then has the error d(R f) = theta x R f - R zeta. At rest, R f = -g, so that this
  // error is g x theta - R zeta.
  Matrix3d up;
  up << 0.0, -gravity.z(), gravity.y(), gravity.z(), 0.0, -gravity.x(), -gravity.y(), gravity.x(),
      0.0;
  const Matrix3d across = up * P.block<3, 3>(0, 12) * unit.R.transpose();
  const double of_force = std::max(0.0, (up * P.block<3, 3>(0, 0) * up.transpose()).trace() +
                                            P.block<3, 3>(12, 12).trace() - 2.0 * across.trace());
  // Variances of turned() and moved() in UnitWatch, as sums over three axes. White noise
  // contributes 3/2 noise^2 time to turned() and 3/4 noise^2 time^3 to moved(). A velocity error v
  // contributes at most v time / e to moved(), where e is Euler's number.
  const double turn = P.block<3, 3>(9, 9).trace() * square(time) +
                      1.5 * square(o.gyro_noise) * time + square(encoder);
  const double place = of_force * square(square(time)) +
                       0.75 * square(o.accelerometer_noise) * time * square(time) +
                       P.block<3, 3>(3, 3).trace() * square(time / M_E) + square(encoder);
  moment.speed_gate = 3.0 * std::sqrt(of_force * square(time) + P.block<3, 3>(3, 3).trace());
  moment.turn_gate = watch_options.turn + 3.0 * std::sqrt(turn);
  moment.place_gate = watch_options.place + 3.0 * std::sqrt(place);
}

/// Replaces both snapshots by the last estimate of the base.
void GuardedBase::Impl::begin_again(FootSet standing) noexcept {
  followed = standing;
  tipping = 0.0;
  by_feet = last_unit();
  take_moment(older, followed, by_feet);
  newer = older;
  since_newer = 0.0;
  Vector3d v_unit, w_unit;
  // Starts with the last estimated velocity. The velocity computed from the feet could be wrong,
  // because a foot may slip.
  if (older.feet.are_redundant(followed) &&
      older.feet.fit_velocity(followed, kinematics, v_unit, w_unit))
    watch.begin(by_feet, last_velocity());
  else
    watch.stop();
}

/// Returns true if the feet have kept their poses relative to each other. If not, `worst` receives
/// the foot to leave out first.
bool GuardedBase::Impl::feet_agree(const UnitPose& unit, FootSet feet, FootSet& worst,
                                   const ConstVectorRef& loads) const noexcept {
  const double noise = 3.0 * encoder_place();
  const double place = watch_options.feet_place + noise, turn = watch_options.feet_turn + noise;
  bool agree = true;
  double max_blame = 0.0;
  worst = 0;
  for (int k = 0; k < kinematics.feet(); ++k) {
    if ((feet & foot_bit(k)) == 0) continue;
    const FeetFit::Apart apart = older.feet.apart(k, kinematics.seen(k), unit);
    const double ratio = std::max(apart.place / place, apart.turn / turn);
    agree = agree && ratio <= 1.0;
    // A foot with less load slips more easily. If only two feet contradict each other, their values
    // of `ratio` are equal, so that the load decides.
    const double blame = ratio / (loads.size() == 0 ? 1.0 : std::max(loads[k], 1.0));
    if (worst != 0 && !(blame > max_blame)) continue;
    max_blame = blame;
    worst = foot_bit(k);
  }
  return agree;
}

void GuardedBase::Impl::compare(const ImuReading& imu, double dt) noexcept {
  ImuReading reading = imu;
  reading.gyro -= older.b_gyro;
  reading.accelerometer -= older.b_accelerometer;
  Vector3d v_unit, w_unit;
  if (!older.feet.fit_velocity(followed, kinematics, v_unit, w_unit)) v_unit.setZero();
  watch.advance(reading, by_feet, by_feet.R * v_unit, gravity, dt);
}

/// Returns the difference between IMU and feet, as a multiple of its thresholds. Above 1, either
/// the IMU or the feet are wrong.
double GuardedBase::Impl::gate_ratio() const noexcept {
  if (!watch.has_begun()) return 0.0;
  const double ratio =
      std::max(watch.turned().norm() / older.turn_gate, watch.moved().norm() / older.place_gate);
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

/// Returns true if the feet are at rest. Feet that tip, pivot or slip move relative to each other,
/// by a large fraction of the difference between IMU and feet. A fault of the IMU, in contrast,
/// causes no relative motion of the feet.
bool GuardedBase::Impl::feet_rest() const noexcept {
  // Largest relative motion of feet at rest, as a fraction of the difference between IMU and feet;
  // chosen by hand.
  constexpr double moving_fraction = 0.25;
  const double max_ratio = moving_fraction * std::max(gate_ratio(), 0.7);
  for (int k = 0; k < kinematics.feet(); ++k) {
    if ((followed & foot_bit(k)) == 0) continue;
    const FeetFit::Apart apart = older.feet.apart(k, kinematics.seen(k), by_feet);
    if (std::max(apart.turn / older.turn_gate, apart.place / older.place_gate) > max_ratio)
      return false;
  }
  return true;
}

UnitWatch::Tips GuardedBase::Impl::tips() const noexcept {
  // Displacement due to the compliance of ground and links [m]; chosen by hand.
  constexpr double compliance = 3e-4;
  return watch.tips_over(older.feet.middle(followed), 0.5 * older.turn_gate,
                         compliance + 4.0 * encoder_place());
}

/// Returns the reading that the filter receives. A sudden difference between the reading and the
/// feet may be a fault, on which a controller could react so strongly that the robot falls. Until
/// the cause is clear, the reading is therefore replaced by the angular velocity from the feet and
/// by zero acceleration.
ImuReading GuardedBase::Impl::vetted_reading(const ImuReading& imu, double dt) const noexcept {
  ImuReading result = imu;
  Vector3d v_unit, w_unit;
  if (!older.feet.fit_velocity(followed, kinematics, v_unit, w_unit)) return result;
  constexpr double lever = 0.4;  // lever arm that converts an angular velocity to a speed [m]
  const BaseEstimatorOptions& o = filter.options();
  const double rate = watch_options.rate + 5.0 * o.gyro_noise / std::sqrt(dt);
  const double speed = lever * watch_options.rate +
                       5.0 * o.accelerometer_noise * std::sqrt(0.5 * watch_options.window) +
                       older.speed_gate;
  const bool turns = (imu.gyro - older.b_gyro - w_unit).norm() > rate;
  const bool speeds = watch.sped().norm() > speed;
  if (!(turns || speeds) || !feet_rest() || tips() == UnitWatch::Tips::Yes) return result;
  if (turns) result.gyro = w_unit + filter.gyro_bias();
  if (speeds)
    result.accelerometer = -(by_feet.R.transpose() * gravity) + filter.accelerometer_bias();
  return result;
}

Status GuardedBase::Impl::follow_filter(const ImuReading* imu, const ConstVectorRef& q_read,
                                        const ConstVectorRef& v_read, FootSet standing,
                                        const ConstVectorRef& loads, double dt) noexcept {
  FootSet worst = 0;
  // If readings are missing, the IMU is rejected at once, even directly after feet were put down.
  bool stands = standing == followed && older.feet.fit(followed, kinematics.all_seen(), by_feet) &&
                feet_agree(by_feet, followed, worst, loads);
  if (imu == nullptr) {
    if (!stands || tipping > 0.0) begin_again(standing);
    give_up_unit(true, standing);
    return Status::Ok;
  }
  ImuReading reading = *imu;
  if (stands && watch_options.enabled && watch.has_begun()) {
    compare(*imu, dt);
    const bool beyond = gate_ratio() > 1.0, was_tipping = tipping > 0.0;
    tipping = std::max(0.0, tipping - dt);
    // Duration of tipping as a multiple of the window. After this time, the effect of tipping has
    // decayed, and the feet are put down again where they are.
    constexpr double windows = 3.0;
    const UnitWatch::Tips tip = tips();
    if (beyond && tip == UnitWatch::Tips::Yes) tipping = windows * watch_options.window;
    const bool rest = feet_rest();
    // Readings with noise never repeat. An IMU with repeated readings is therefore rejected after a
    // small motion of the feet. `min_motion`: difference between IMU and feet, as a multiple of its
    // thresholds.
    constexpr double min_motion = 0.2;
    if (watch.repeats_for() > stuck && gate_ratio() > min_motion) {
      give_up_unit(false, standing);
      return Status::Ok;
    }
    // Difference, as a multiple of the thresholds, at which a fault of the IMU is certain; chosen
    // by hand.
    constexpr double clear = 3.0;
    if (beyond && rest && tipping == 0.0 && !was_tipping &&
        (tip == UnitWatch::Tips::No || gate_ratio() > clear)) {
      give_up_unit(false, standing);
      return Status::Ok;
    }
    stands = tipping > 0.0 || !(was_tipping || (beyond && !rest));
    if (stands && tipping == 0.0) reading = vetted_reading(*imu, dt);
  }
  const Status status = filter.update(reading, q_read, v_read, standing, dt);
  if (status != Status::Ok) {
    if (dt <= watch_options.silent_after) return status;
    if (!stands) begin_again(standing);
    give_up_unit(true, standing);
    return Status::Ok;
  }
  q = filter.q();
  v = filter.v();
  if (!stands) {
    begin_again(standing);
    return status;
  }
  since_newer += dt;
  if (since_newer < moment_period || tipping > 0.0 || gate_ratio() > 0.5) return status;
  older = newer;
  take_moment(newer, followed, last_unit());
  since_newer = 0.0;
  if (older.feet.fit(followed, kinematics.all_seen(), by_feet)) watch.shift(by_feet);
  return status;
}

/// Rejects the IMU. The feet are assumed to stand at their poses in the older snapshot.
void GuardedBase::Impl::give_up_unit(bool silent, FootSet standing) noexcept {
  const UnitPose last = last_unit();
  source = BaseSource::Feet;
  was_silent = silent;
  out = 0;
  rested.setZero();
  followed = standing;
  agreed = lost = 0.0;
  ++takeovers;
  off_turn = turn_of(last.R * by_feet.R.transpose());
  off_place = last.p - by_feet.p;
  watch.stop();
}

/// Updates the set of standing feet, and the pose of the IMU computed from them. Returns false if
/// the feet do not determine the pose.
bool GuardedBase::Impl::stand(FootSet standing, const ConstVectorRef& loads, double dt) noexcept {
  const std::vector<SeenFoot>& seen = kinematics.all_seen();
  Vector3d v_unit, w_unit;
  out &= standing;
  FootSet stay = followed & standing & ~out;
  if (stay != followed) watch.stop();
  if (!older.feet.fit(stay, seen, by_feet)) {
    // Puts all standing feet down, relative to the last estimate of the base.
    stay = standing;
    out = 0;
    by_feet = last_unit();
    older.feet.put(stay, by_feet, seen);
    off_turn.setZero();
    off_place.setZero();
    followed = stay;
    return older.feet.fit(stay, seen, by_feet);
  }
  FootSet worst = 0;
  if (older.feet.are_redundant(stay) && !feet_agree(by_feet, stay, worst, loads)) {
    const UnitPose with = by_feet;
    if (older.feet.fit(stay & ~worst, seen, by_feet)) {
      stay &= ~worst;
      out |= worst;
      off_turn += turn_of(with.R * by_feet.R.transpose());
      off_place += with.p - by_feet.p;
      watch.stop();
    }
  }
  if (!older.feet.fit_velocity(stay, kinematics, v_unit, w_unit)) return false;
  for (int k = 0; k < kinematics.feet(); ++k) {
    if ((standing & ~stay & foot_bit(k)) == 0) continue;
    const Vector3d speed =
        v_unit + w_unit.cross(to_eigen(kinematics.seen(k).p)) + to_eigen(kinematics.velocity(k));
    const bool rests = speed.norm() < filter.options().rejoin_speed;
    rested[k] = (worst & foot_bit(k)) != 0 || !rests ? 0.0 : rested[k] + dt;
    if ((out & foot_bit(k)) != 0 && rested[k] < filter.options().rejoin_after) continue;
    older.feet.put(foot_bit(k), by_feet, seen);
    stay |= foot_bit(k);
    out &= ~foot_bit(k);
  }
  followed = stay;
  return true;
}

void GuardedBase::Impl::follow_feet(const ImuReading* imu, FootSet standing,
                                    const ConstVectorRef& loads, double dt) noexcept {
  Vector3d v_unit = Vector3d::Zero(), w_unit = Vector3d::Zero();
  const bool stands =
      stand(standing, loads, dt) && older.feet.fit_velocity(followed, kinematics, v_unit, w_unit);
  if (!stands) {
    source = BaseSource::None;
    lost += dt;
    v.head<6>() *= std::exp(-dt / watch_options.decay_time);
    watch.stop();
    // If the feet give no pose, accepts an IMU that was rejected only for missing readings.
    if (imu != nullptr && was_silent) take_unit_back(older.b_gyro);
    return;
  }
  source = BaseSource::Feet;
  lost = 0.0;
  const double decay = std::exp(-dt / watch_options.decay_time);
  off_turn *= decay;
  off_place *= decay;
  set_base({turned_by(off_turn) * by_feet.R, by_feet.p + off_place}, v_unit, w_unit);
  if (imu == nullptr) {
    watch.stop();
    agreed = 0.0;
    return;
  }
  if (!watch.has_begun()) {
    watch.begin(by_feet, by_feet.R * v_unit);
    agreed = 0.0;
    return;
  }
  compare(*imu, dt);
  // Difference, as a multiple of the thresholds, below which the IMU is accepted again. It is
  // clearly below 1, so that the IMU is not rejected again at once.
  constexpr double closely = 0.6;
  if (gate_ratio() > closely || watch.repeats_for() > stuck) {
    watch.begin(by_feet, by_feet.R * v_unit);
    agreed = 0.0;
    return;
  }
  agreed += dt;
  if (agreed >= watch_options.back_after) take_unit_back(older.b_gyro + watch.mean_rate());
}

void GuardedBase::Impl::take_unit_back(const Vector3d& b_gyro) noexcept {
  if (filter.resume(q, v, b_gyro, older.b_accelerometer) != Status::Ok) return;
  source = BaseSource::Filter;
  lost = agreed = 0.0;
  followed = 0;  // standing feet are added again at the next reading
  watch.stop();
}

const Eigen::VectorXd& GuardedBase::q() const { return impl_->q; }
const Eigen::VectorXd& GuardedBase::v() const { return impl_->v; }
Eigen::Matrix3d GuardedBase::foot_rotation(int foot) const {
  const Impl& d = *impl_;
  if (d.source == BaseSource::Filter) return d.filter.foot_rotation(foot);
  return d.by_feet.R * to_eigen(d.kinematics.seen(foot).R);
}
BaseSource GuardedBase::source() const { return impl_->source; }
double GuardedBase::lost_for() const { return impl_->lost; }
int GuardedBase::takeovers() const { return impl_->takeovers; }
const BaseEstimator& GuardedBase::filter() const { return impl_->filter; }

}  // namespace burnish
