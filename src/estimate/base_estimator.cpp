#include "burnish/estimate/base_estimator.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "estimate/chi_square.hpp"
#include "estimate/contact_filter.hpp"
#include "estimate/descriptions.gen.hpp"
#include "estimate/foot_kinematics.hpp"

namespace burnish {
namespace {

using Eigen::Vector3d;

const BaseEstimatorOptions& checked(const BaseEstimatorOptions& options) {
  check_ranges(description_of(&options), &options,
               [](const std::string& entry) { return "the estimator's " + in_quotes(entry); });
  if (options.feet.empty() || options.feet.size() > 32)
    throw Error("the estimator has " + std::to_string(options.feet.size()) +
                " feet; wanted 1 to 32");
  for (std::size_t i = 0; i < options.feet.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (options.feet[i].frame == options.feet[j].frame)
        throw Error("the estimator has the foot " + in_quotes(options.feet[i].frame) +
                    " twice; wanted each foot once");
  return options;
}

std::vector<std::string> frames_of(const std::vector<FootSpec>& feet) {
  std::vector<std::string> result;
  for (const FootSpec& foot : feet) result.push_back(foot.frame);
  return result;
}
std::vector<char> soles_of(const std::vector<FootSpec>& feet) {
  std::vector<char> result;
  for (const FootSpec& foot : feet) result.push_back(foot.kind == FootKind::Sole ? 1 : 0);
  return result;
}
FilterNoise noise_of(const BaseEstimatorOptions& o) {
  return {o.gyro_noise, o.accelerometer_noise, o.gyro_bias_walk, o.accelerometer_bias_walk,
          o.slip_noise, o.sole_turn_noise};
}

Eigen::MatrixXd initial_covariance(const BaseEstimatorOptions& o, const Vector3d& gravity) {
  const auto square = [](double deviation) { return deviation * deviation; };
  Eigen::VectorXd squares(15);
  squares.segment<3>(0).setConstant(square(o.tilt_deviation));
  squares.segment<3>(3).setConstant(square(o.velocity_deviation));
  squares.segment<3>(6).setConstant(square(o.position_deviation));
  squares.segment<3>(9).setConstant(square(o.gyro_bias_deviation));
  squares.segment<3>(12).setConstant(square(o.accelerometer_bias_deviation));
  Eigen::MatrixXd P = squares.asDiagonal();
  const Vector3d up = gravity.norm() > 0.0 ? Vector3d(-gravity.normalized()) : Vector3d::UnitZ();
  P.topLeftCorner<3, 3>() +=
      (square(o.yaw_deviation) - square(o.tilt_deviation)) * up * up.transpose();
  return P;
}

/// Converts the covariance P of the errors of rotation (theta), velocity (dv) and position (dp) in
/// world axes to the covariance of the filter's error xi (`sign` 1), or back (`sign` -1). The
/// errors satisfy xi_v = dv + v x theta and xi_p = dp + p x theta.
void change_coordinates(const InertialState<double>& x, double sign, Eigen::MatrixXd& P) {
  Eigen::Matrix3d v, p;
  v << 0.0, -x.v.z, x.v.y, x.v.z, 0.0, -x.v.x, -x.v.y, x.v.x, 0.0;
  p << 0.0, -x.p.z, x.p.y, x.p.z, 0.0, -x.p.x, -x.p.y, x.p.x, 0.0;
  v *= sign;
  p *= sign;
  for (int side = 0; side < 2; ++side) {
    P.middleRows<3>(ContactFilter::v).noalias() += v * P.topRows<3>();
    P.middleRows<3>(ContactFilter::p).noalias() += p * P.topRows<3>();
    P.transposeInPlace();
  }
}

bool is_covariance(const Eigen::Ref<const Eigen::MatrixXd>& P) {
  const double scale = P.cwiseAbs().maxCoeff();
  if (!((P - P.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * scale)) return false;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(P, Eigen::EigenvaluesOnly);
  return eigen.info() == Eigen::Success && eigen.eigenvalues().minCoeff() >= -1e-9 * scale;
}

}  // namespace

struct BaseEstimator::Impl {
  Impl(const Model& model, const BaseEstimatorOptions& given)
      : options(checked(given)),
        kinematics(model, options.imu_frame, frames_of(options.feet)),
        filter(soles_of(options.feet), noise_of(options), model.gravity),
        initial(initial_covariance(options, model.gravity)),
        q(model.q_neutral),
        v(Eigen::VectorXd::Zero(model.nv)),
        covariance(initial),
        start_covariance(initial),
        jacobian(Eigen::MatrixXd::Zero(filter.seen_size(),
                                       static_cast<Eigen::Index>(kinematics.columns().size()))),
        noise(Eigen::MatrixXd::Zero(filter.seen_size(), filter.seen_size())),
        gates(filter.feet()),
        rested(Eigen::VectorXd::Zero(filter.feet())) {
    for (int k = 0; k < filter.feet(); ++k)
      gates[k] = chi_square_quantile(filter.rows(k), options.gate);
    start(model.q_neutral, v, initial);
  }

  void start(const ConstVectorRef& q_start, const ConstVectorRef& v_start,
             const Eigen::Ref<const Eigen::MatrixXd>& P, const Vector3d& b_gyro = Vector3d::Zero(),
             const Vector3d& b_accelerometer = Vector3d::Zero()) noexcept;
  void update_foot_noise() noexcept;
  void follow_slips(FootSet standing, FootSet rejected, const Vector3d& gyro, double dt) noexcept;
  double speed_limit() const noexcept;
  void update_base(const Vector3d& gyro) noexcept;

  BaseEstimatorOptions options;
  FootKinematics kinematics;
  ContactFilter filter;
  Eigen::MatrixXd initial;  ///< Initial covariance, from the options.
  Eigen::VectorXd q, v;
  Eigen::MatrixXd covariance, start_covariance;
  Eigen::MatrixXd jacobian, noise;
  Eigen::VectorXd gates;   ///< Squared innovation above which a foot is an outlier, per foot.
  Eigen::VectorXd rested;  ///< Time since each foot in `slipping` stopped sliding [s].
  FootSet slipping = 0;
  double lost = 0.0;  ///< Time for which all standing feet have been slipping [s].
  EstimatorInnovation innovation;
};

BaseEstimator::BaseEstimator(const Model& model, const BaseEstimatorOptions& options)
    : impl_(std::make_unique<Impl>(model, options)) {}
BaseEstimator::~BaseEstimator() = default;
BaseEstimator::BaseEstimator(BaseEstimator&&) noexcept = default;
BaseEstimator& BaseEstimator::operator=(BaseEstimator&&) noexcept = default;

/// Starts the filter. Before the call, the kinematics must be updated to q_start and v_start.
void BaseEstimator::Impl::start(const ConstVectorRef& q_start, const ConstVectorRef& v_start,
                                const Eigen::Ref<const Eigen::MatrixXd>& P, const Vector3d& b_gyro,
                                const Vector3d& b_accelerometer) noexcept {
  q = q_start;
  v = v_start;
  const FramePose<double>& joint = kinematics.base_joint();
  const Eigen::Quaterniond turn(q[6], q[3], q[4], q[5]);
  const Mat3<double> R_base = joint.R * from_eigen(turn.normalized().toRotationMatrix());
  const Vec3<double> p_base = joint.p + joint.R * Vec3<double>{q[0], q[1], q[2]};
  const FramePose<double>& unit = kinematics.unit_in_base();
  const Vec3<double> v_base{v[0], v[1], v[2]}, w_base{v[3], v[4], v[5]};
  const InertialState<double> state{
      R_base * unit.R,
      R_base * (v_base + cross(w_base, unit.p) + kinematics.unit_in_base_velocity().linear),
      p_base + R_base * unit.p};
  start_covariance = P;
  change_coordinates(state, 1.0, start_covariance);
  filter.reset(state, b_gyro, b_accelerometer, start_covariance);
  slipping = 0;
  lost = 0.0;
  rested.setZero();
  innovation = {};
}

/// Updates the noise covariance of the foot poses relative to the IMU.
void BaseEstimator::Impl::update_foot_noise() noexcept {
  for (int k = 0; k < filter.feet(); ++k)
    jacobian.middleRows(filter.first_seen(k), filter.rows(k)) =
        kinematics.jacobian(k).topRows(filter.rows(k));
  noise.noalias() = jacobian * jacobian.transpose();
  noise *= options.encoder_noise * options.encoder_noise;
  const double place = options.place_noise * options.place_noise;
  const double turn = options.turn_noise * options.turn_noise;
  for (int k = 0; k < filter.feet(); ++k) {
    const int row = filter.first_seen(k);
    noise.diagonal().segment<3>(row).array() += place;
    if (filter.rows(k) == 6) noise.diagonal().segment<3>(row + 3).array() += turn;
  }
}

/// Returns the speed below which a slipping foot counts as at rest [m/s]. It includes three
/// standard deviations of the IMU's velocity, so that a base can recover after all feet slipped.
double BaseEstimator::Impl::speed_limit() const noexcept {
  const Eigen::MatrixXd& P = filter.covariance();
  const Vec3<double>& v_unit = filter.state().v;
  Eigen::Matrix3d cross_v;
  cross_v << 0.0, -v_unit.z, v_unit.y, v_unit.z, 0.0, -v_unit.x, -v_unit.y, v_unit.x, 0.0;
  constexpr int R = ContactFilter::R, at = ContactFilter::v;
  const Eigen::Matrix3d turned = cross_v * P.block<3, 3>(R, at);
  const double square = P.block<3, 3>(at, at).trace() - 2.0 * turned.trace() +
                        (cross_v * P.block<3, 3>(R, R) * cross_v.transpose()).trace();
  return options.rejoin_speed + 3.0 * std::sqrt(std::max(square, 0.0));
}

/// Removes slipping feet from the filter, and adds them again once they are at rest.
void BaseEstimator::Impl::follow_slips(FootSet standing, FootSet rejected, const Vector3d& gyro,
                                       double dt) noexcept {
  filter.remove(rejected);
  slipping = (slipping | rejected) & standing;
  const double limit = speed_limit();
  FootSet rests = 0;
  double fastest = 0.0;
  for (int k = 0; k < filter.feet(); ++k) {
    if ((rejected & foot_bit(k)) != 0) rested[k] = 0.0;
    if ((slipping & ~rejected & foot_bit(k)) == 0) continue;
    const Vec3<double> w = from_eigen(Vector3d(gyro - filter.b_gyro()));
    const InertialState<double>& unit = filter.state();
    const Vec3<double> speed =
        unit.v + unit.R * (kinematics.velocity(k) + cross(w, kinematics.seen(k).p));
    const double length = std::sqrt(dot(speed, speed));
    fastest = std::max(fastest, length);
    // The rest time decreases gradually, so that a single noisy reading does not reset it.
    rested[k] = std::max(0.0, rested[k] + (length < limit ? dt : -dt));
    if (rested[k] >= options.rejoin_after) rests |= foot_bit(k);
  }
  slipping &= ~rests;
  lost = filter.standing() == 0 && slipping != 0 && slipping == standing ? lost + dt : 0.0;
  if (lost > options.lost_after) {
    filter.doubt_velocity(fastest);
    slipping = 0;
    lost = 0.0;
  }
  filter.add(standing & ~slipping, kinematics.all_seen(), noise);
}

/// Computes the state of the base from the state of the IMU.
void BaseEstimator::Impl::update_base(const Vector3d& gyro_reading) noexcept {
  const FramePose<double>& unit = kinematics.unit_in_base();
  const FramePose<double>& joint = kinematics.base_joint();
  const InertialState<double>& x = filter.state();
  const Mat3<double> R_base = x.R * transposed(unit.R);
  const Vec3<double> p_base = x.p - R_base * unit.p;
  q.head<3>() = to_eigen(transpose_times(joint.R, p_base - joint.p));
  Eigen::Quaterniond turn(to_eigen(transpose_times(joint.R, R_base)));
  turn.normalize();
  const double side = turn.coeffs().dot(q.segment<4>(3)) < 0.0 ? -1.0 : 1.0;
  q.segment<4>(3) = side * turn.coeffs();
  const Motion<double>& moves = kinematics.unit_in_base_velocity();
  const Vec3<double> w =
      unit.R * from_eigen(Vector3d(gyro_reading - filter.b_gyro())) - moves.angular;
  v.segment<3>(3) = to_eigen(w);
  v.head<3>() = to_eigen(transpose_times(R_base, x.v) - cross(w, unit.p) - moves.linear);
}

Status BaseEstimator::reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  return reset(q, v, impl_->initial);
}

Status BaseEstimator::reset(const ConstVectorRef& q, const ConstVectorRef& v,
                            const Eigen::Ref<const Eigen::MatrixXd>& covariance) noexcept {
  Impl& d = *impl_;
  if (q.size() != d.q.size() || v.size() != d.v.size() || covariance.rows() != 15 ||
      covariance.cols() != 15)
    return Status::WrongSize;
  if (!q.allFinite() || !v.allFinite() || !covariance.allFinite()) return Status::NotFinite;
  if (!(std::abs(q.segment<4>(3).squaredNorm() - 1.0) < 2e-6)) return Status::NotNormalized;
  if (!is_covariance(covariance)) return Status::NotPhysical;
  const Status status = d.kinematics.update(q, v);
  if (status != Status::Ok) return status;
  d.start(q, v, covariance);
  return Status::Ok;
}

Status BaseEstimator::resume(const ConstVectorRef& q, const ConstVectorRef& v,
                             const Eigen::Vector3d& gyro_bias,
                             const Eigen::Vector3d& accelerometer_bias) noexcept {
  Impl& d = *impl_;
  if (q.size() != d.q.size() || v.size() != d.v.size()) return Status::WrongSize;
  if (!q.allFinite() || !v.allFinite() || !gyro_bias.allFinite() || !accelerometer_bias.allFinite())
    return Status::NotFinite;
  if (!(std::abs(q.segment<4>(3).squaredNorm() - 1.0) < 2e-6)) return Status::NotNormalized;
  const Status status = d.kinematics.update(q, v);
  if (status != Status::Ok) return status;
  (void)covariance();
  d.covariance += d.initial;
  d.start(q, v, d.covariance, gyro_bias, accelerometer_bias);
  return Status::Ok;
}

Status BaseEstimator::update(const ImuReading& imu, const ConstVectorRef& q,
                             const ConstVectorRef& v, Feet standing, double dt) noexcept {
  Impl& d = *impl_;
  if (!imu.gyro.allFinite() || !imu.accelerometer.allFinite() || !(dt > 0.0) || !std::isfinite(dt))
    return Status::NotFinite;
  const Status status = d.kinematics.update(q, v);
  if (status != Status::Ok) return status;
  if (d.filter.feet() < 32) standing &= foot_bit(d.filter.feet()) - 1;
  d.filter.save();
  const FootSet slipped = d.slipping;
  const double lost = d.lost;
  d.filter.propagate(imu, dt);
  d.update_foot_noise();
  d.filter.remove(d.filter.standing() & ~standing);
  bool good = true;
  const FootSet rejected =
      d.filter.update(standing, d.kinematics.all_seen(), d.noise, d.gates, good);
  if (good) d.follow_slips(standing, rejected, imu.gyro, dt);
  if (!good || !d.filter.is_finite()) {
    d.filter.restore();
    d.slipping = slipped;
    d.lost = lost;
    return Status::NotFinite;
  }
  d.q.tail(d.q.size() - 7) = q.tail(d.q.size() - 7);
  d.v.tail(d.v.size() - 6) = v.tail(d.v.size() - 6);
  d.update_base(imu.gyro);
  d.innovation = {d.filter.squared_innovation(), d.filter.innovation_rows()};
  return Status::Ok;
}

const Eigen::VectorXd& BaseEstimator::q() const { return impl_->q; }
const Eigen::VectorXd& BaseEstimator::v() const { return impl_->v; }

const Eigen::MatrixXd& BaseEstimator::covariance() const {
  impl_->covariance = impl_->filter.covariance().topLeftCorner<15, 15>();
  change_coordinates(impl_->filter.state(), -1.0, impl_->covariance);
  return impl_->covariance;
}

const Eigen::Vector3d& BaseEstimator::gyro_bias() const { return impl_->filter.b_gyro(); }
const Eigen::Vector3d& BaseEstimator::accelerometer_bias() const {
  return impl_->filter.b_accelerometer();
}
Eigen::Vector3d BaseEstimator::foot_position(int foot) const {
  return to_eigen(impl_->filter.foot_position(foot));
}
Eigen::Matrix3d BaseEstimator::foot_rotation(int foot) const {
  return to_eigen(impl_->filter.state().R * impl_->kinematics.seen(foot).R);
}
BaseEstimator::Feet BaseEstimator::feet_that_count() const { return impl_->filter.standing(); }
BaseEstimator::Feet BaseEstimator::feet_that_slip() const { return impl_->slipping; }
const EstimatorInnovation& BaseEstimator::innovation() const { return impl_->innovation; }
FootKinematics& BaseEstimator::kinematics() noexcept { return impl_->kinematics; }
int BaseEstimator::feet() const { return impl_->filter.feet(); }
const BaseEstimatorOptions& BaseEstimator::options() const { return impl_->options; }

}  // namespace burnish
