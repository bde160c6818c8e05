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
std::vector<std::string> frames_in(const BaseEstimatorOptions& options) {
  std::vector<std::string> result;
  for (const FootSpec& foot : options.feet) result.push_back(foot.frame);
  return result;
}

/// m that a radian of a sole counts as, by how the two creep: soles that turn on the spot are not
/// to take the yaw along.
double length_of(const BaseEstimatorOptions& options) {
  const double turns = std::max(options.sole_turn_noise, 1e-9);
  return std::clamp(options.slip_noise / turns, 0.05, 0.5);
}

/// Where feet stood at a time, the biases that were believed then, and how far unit and feet may
/// come apart by what was not known.
struct Moment {
  Moment(const std::vector<char>& soles, double length) : feet(soles, length) {}
  FeetFit feet;
  Vector3d b_gyro = Vector3d::Zero(), b_accelerometer = Vector3d::Zero();
  double turn_gate = 0.0, place_gate = 0.0;  ///< rad, m
  double speed_gate = 0.0;                   ///< m/s, of what is not known
};

constexpr double stuck = 0.01;          // s of the same reading, to the last digit
constexpr double moment_period = 0.25;  // s: a fault is found within it, and anchors are older

}  // namespace

struct GuardedBase::Impl {
  Impl(const Model& model, const BaseEstimatorOptions& options)
      : filter(model, options),
        watch_options(options.watch),
        kinematics(model, options.imu_frame, frames_in(options)),
        watch(options.watch.window),
        older(soles_in(options), length_of(options)),
        newer(older),
        gravity(model.gravity),
        q(model.q_neutral),
        v(Eigen::VectorXd::Zero(model.nv)),
        rested(Eigen::VectorXd::Zero(filter.feet())) {}

  UnitPose told_unit() const noexcept;
  Vector3d told_velocity() const noexcept;
  void tell_unit(const UnitPose& at, const Vector3d& v_unit, const Vector3d& w_unit) noexcept;
  void take_moment(Moment& moment, FootSet feet, const UnitPose& unit) noexcept;
  void begin_again(FootSet standing) noexcept;
  bool feet_agree(const UnitPose& unit, FootSet feet, FootSet& worst,
                  const ConstVectorRef& loads) const noexcept;
  double encoder_place() const noexcept;
  void compare(const ImuReading& imu, double dt) noexcept;
  double share_of_gates() const noexcept;
  bool feet_rest() const noexcept;
  UnitWatch::Tips tips() const noexcept;
  ImuReading believed(const ImuReading& imu, double dt) const noexcept;
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
  FootKinematics kinematics;
  UnitWatch watch;
  Moment older, newer;       ///< at least `moment_period` ago but after a beginning, and since
  double since_newer = 0.0;  ///< s
  FootSet followed = 0;      ///< feet that both moments are of
  UnitPose by_feet;          ///< at the older moment's feet
  Vector3d gravity;
  Eigen::VectorXd q, v;
  BaseSource source = BaseSource::Filter;
  bool was_silent = false;  ///< the unit was given up since it said nothing
  double tipping = 0.0;     ///< s in which the robot is still believed to tip
  double lost = 0.0, agreed = 0.0;
  int takeovers = 0;
  Vector3d off_turn = Vector3d::Zero(), off_place = Vector3d::Zero();  ///< rad, m, world: to fade
  FootSet out = 0;         ///< that contradict the others
  Eigen::VectorXd rested;  ///< s, of those
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

/// By the base that was told last, and the joints of now.
UnitPose GuardedBase::Impl::told_unit() const noexcept {
  const FramePose<double>& joint = kinematics.base_joint();
  const FramePose<double>& unit = kinematics.unit_in_base();
  const Matrix3d R_base =
      to_eigen(joint.R) * Eigen::Quaterniond(q[6], q[3], q[4], q[5]).toRotationMatrix();
  const Vector3d p_base = to_eigen(joint.p) + to_eigen(joint.R) * q.head<3>();
  return {R_base * to_eigen(unit.R), p_base + R_base * to_eigen(unit.p)};
}

/// Of the unit, world axes.
Vector3d GuardedBase::Impl::told_velocity() const noexcept {
  const FramePose<double>& unit = kinematics.unit_in_base();
  const Vector3d w_base = v.segment<3>(3);
  const Vector3d in_base = v.head<3>() + w_base.cross(to_eigen(unit.p)) +
                           to_eigen(kinematics.unit_in_base_velocity().linear);
  return to_eigen(kinematics.base_joint().R) *
         (Eigen::Quaterniond(q[6], q[3], q[4], q[5]).toRotationMatrix() * in_base);
}

/// v_unit, w_unit: in its axes.
void GuardedBase::Impl::tell_unit(const UnitPose& at, const Vector3d& v_unit,
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

/// m, a deviation of where a foot is seen, and within a factor of 2 rad of how it is turned.
double GuardedBase::Impl::encoder_place() const noexcept {
  double most = 0.0;
  for (int k = 0; k < kinematics.feet(); ++k)
    most = std::max(most, kinematics.jacobian(k).squaredNorm());
  return filter.options().encoder_noise * std::sqrt(most);
}

/// Gates are what the options say and three times what comes of noise and of what biases and tilt
/// are not known by: of three axes together, which makes five of one.
void GuardedBase::Impl::take_moment(Moment& moment, FootSet feet, const UnitPose& unit) noexcept {
  const BaseEstimatorOptions& o = filter.options();
  moment.feet.put(feet, unit, kinematics.all_seen());
  moment.b_gyro = filter.gyro_bias();
  moment.b_accelerometer = filter.accelerometer_bias();
  const Eigen::MatrixXd& P = filter.covariance();
  const double time = watch_options.window, encoder = encoder_place();
  const auto square = [](double x) { return x * x; };
  // d(R f) = theta x R f - R zeta, which at rest, R f = -g, is g x theta - R zeta.
  Matrix3d up;
  up << 0.0, -gravity.z(), gravity.y(), gravity.z(), 0.0, -gravity.x(), -gravity.y(), gravity.x(),
      0.0;
  const Matrix3d across = up * P.block<3, 3>(0, 12) * unit.R.transpose();
  const double of_force = std::max(0.0, (up * P.block<3, 3>(0, 0) * up.transpose()).trace() +
                                            P.block<3, 3>(12, 12).trace() - 2.0 * across.trace());
  const double turn = P.block<3, 3>(9, 9).trace() * square(time) +
                      1.5 * square(o.gyro_noise) * time + square(encoder);
  const double place = of_force * square(square(time)) +
                       0.75 * square(o.accelerometer_noise) * time * square(time) +
                       P.block<3, 3>(3, 3).trace() * square(time / M_E) + square(encoder);
  moment.speed_gate = 3.0 * std::sqrt(of_force * square(time) + P.block<3, 3>(3, 3).trace());
  moment.turn_gate = watch_options.turn + 3.0 * std::sqrt(turn);
  moment.place_gate = watch_options.place + 3.0 * std::sqrt(place);
}

/// From where the base is told to be now.
void GuardedBase::Impl::begin_again(FootSet standing) noexcept {
  followed = standing;
  tipping = 0.0;
  by_feet = told_unit();
  take_moment(older, followed, by_feet);
  newer = older;
  since_newer = 0.0;
  Vector3d v_unit, w_unit;
  // What the feet say of its velocity may be what one of them slips with: it is the one told.
  if (older.feet.are_redundant(followed) &&
      older.feet.fit_velocity(followed, kinematics, v_unit, w_unit))
    watch.begin(by_feet, told_velocity());
  else
    watch.stop();
}

/// Whether feet are to each other as they were; else `worst` is the one that they do without.
bool GuardedBase::Impl::feet_agree(const UnitPose& unit, FootSet feet, FootSet& worst,
                                   const ConstVectorRef& loads) const noexcept {
  const double noise = 3.0 * encoder_place();
  const double place = watch_options.feet_place + noise, turn = watch_options.feet_turn + noise;
  bool agree = true;
  double most = 0.0;
  worst = 0;
  for (int k = 0; k < kinematics.feet(); ++k) {
    if ((feet & foot_bit(k)) == 0) continue;
    const FeetFit::Apart apart = older.feet.apart(k, kinematics.seen(k), unit);
    const double share = std::max(apart.place / place, apart.turn / turn);
    agree = agree && share <= 1.0;
    // What bears less slips more easily, and two that contradict each other do so alike.
    const double blame = share / (loads.size() == 0 ? 1.0 : std::max(loads[k], 1.0));
    if (worst != 0 && !(blame > most)) continue;
    most = blame;
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

/// How far unit and feet have come apart; above 1 one of them is wrong.
double GuardedBase::Impl::share_of_gates() const noexcept {
  if (!watch.has_begun()) return 0.0;
  const double share =
      std::max(watch.turned().norm() / older.turn_gate, watch.moved().norm() / older.place_gate);
  return std::isfinite(share) ? share : std::numeric_limits<double>::infinity();
}

/// Feet that tip, pivot or slip never do so quite alike: what moves them against each other is a
/// good part of what they differ from the unit by, which a fault of the unit does not touch.
bool GuardedBase::Impl::feet_rest() const noexcept {
  constexpr double part = 0.25;
  const double most = part * std::max(share_of_gates(), 0.7);
  for (int k = 0; k < kinematics.feet(); ++k) {
    if ((followed & foot_bit(k)) == 0) continue;
    const FeetFit::Apart apart = older.feet.apart(k, kinematics.seen(k), by_feet);
    if (std::max(apart.turn / older.turn_gate, apart.place / older.place_gate) > most) return false;
  }
  return true;
}

UnitWatch::Tips GuardedBase::Impl::tips() const noexcept {
  constexpr double bent = 3e-4;  // m, that ground and links give way by
  return watch.tips_over(older.feet.middle(followed), 0.5 * older.turn_gate,
                         bent + 4.0 * encoder_place());
}

/// Until it is clear what is wrong, what leaps away from the feet is not handed on: a controller
/// would have thrown the robot over by then. Turns are theirs instead, and no acceleration.
ImuReading GuardedBase::Impl::believed(const ImuReading& imu, double dt) const noexcept {
  ImuReading result = imu;
  Vector3d v_unit, w_unit;
  if (!older.feet.fit_velocity(followed, kinematics, v_unit, w_unit)) return result;
  constexpr double lever = 0.4;  // m, that a rate counts at as a speed
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
  // A unit that says nothing does not wait for feet that were put down just now.
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
    const bool beyond = share_of_gates() > 1.0, was_tipping = tipping > 0.0;
    tipping = std::max(0.0, tipping - dt);
    // What has come of it is forgotten after that time, and the feet stand elsewhere then.
    constexpr double windows = 3.0;
    const UnitWatch::Tips tip = tips();
    if (beyond && tip == UnitWatch::Tips::Yes) tipping = windows * watch_options.window;
    const bool rest = feet_rest();
    // Noise never repeats itself: then it is enough that the feet tell of any motion at all.
    constexpr double any = 0.2;  // of the gates
    if (watch.repeats_for() > stuck && share_of_gates() > any) {
      give_up_unit(false, standing);
      return Status::Ok;
    }
    constexpr double clear = 3.0;  // of the gates: nothing more is waited for
    if (beyond && rest && tipping == 0.0 && !was_tipping &&
        (tip == UnitWatch::Tips::No || share_of_gates() > clear)) {
      give_up_unit(false, standing);
      return Status::Ok;
    }
    stands = tipping > 0.0 || !(was_tipping || (beyond && !rest));
    if (stands && tipping == 0.0) reading = believed(*imu, dt);
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
  if (since_newer < moment_period || tipping > 0.0 || share_of_gates() > 0.5) return status;
  older = newer;
  take_moment(newer, followed, told_unit());
  since_newer = 0.0;
  if (older.feet.fit(followed, kinematics.all_seen(), by_feet)) watch.shift(by_feet);
  return status;
}

/// The feet stand where they did at the older moment.
void GuardedBase::Impl::give_up_unit(bool silent, FootSet standing) noexcept {
  const UnitPose told = told_unit();
  source = BaseSource::Feet;
  was_silent = silent;
  out = 0;
  rested.setZero();
  followed = standing;
  agreed = lost = 0.0;
  ++takeovers;
  off_turn = turn_of(told.R * by_feet.R.transpose());
  off_place = told.p - by_feet.p;
  watch.stop();
}

/// Feet that came, went or slip; where the unit is by those that stand.
bool GuardedBase::Impl::stand(FootSet standing, const ConstVectorRef& loads, double dt) noexcept {
  const std::vector<SeenFoot>& seen = kinematics.all_seen();
  Vector3d v_unit, w_unit;
  out &= standing;
  FootSet stay = followed & standing & ~out;
  if (stay != followed) watch.stop();
  if (!older.feet.fit(stay, seen, by_feet)) {
    // Whatever stands now is put down where the base was last told to be.
    stay = standing;
    out = 0;
    by_feet = told_unit();
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
    v.head<6>() *= std::exp(-dt / watch_options.fading);
    watch.stop();
    // A unit that was silent and speaks again is better than nothing.
    if (imu != nullptr && was_silent) take_unit_back(older.b_gyro);
    return;
  }
  source = BaseSource::Feet;
  lost = 0.0;
  const double stays = std::exp(-dt / watch_options.fading);
  off_turn *= stays;
  off_place *= stays;
  tell_unit({turned_by(off_turn) * by_feet.R, by_feet.p + off_place}, v_unit, w_unit);
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
  constexpr double closely = 0.6;  // of the gates: a unit that comes back is not to leave at once
  if (share_of_gates() > closely || watch.repeats_for() > stuck) {
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
  followed = 0;  // what stands is put down at the next reading
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
