#include "estimate/contact_filter.hpp"

#include <Eigen/Cholesky>

#include "base/to_size.hpp"
#include "math/logarithm.hpp"

namespace burnish {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vec3<double> segment(const Eigen::VectorXd& x, int at) { return {x[at], x[at + 1], x[at + 2]}; }

Matrix3d skew(const Vec3<double>& a) {
  Matrix3d m;
  m << 0.0, -a.z, a.y, a.z, 0.0, -a.x, -a.y, a.x, 0.0;
  return m;
}

/// Returns a rotation matrix without its rounding error, to second order: R (3 - R^T R)/2.
Mat3<double> orthonormal(const Mat3<double>& R) {
  Mat3<double> half = transpose_times(R, R);
  half = {half.c0 * -0.5, half.c1 * -0.5, half.c2 * -0.5};
  half.c0.x += 1.5, half.c1.y += 1.5, half.c2.z += 1.5;
  return R * half;
}

/// Sets `out` to R N R^T for every 3 x 3 block N of `noise`.
void turn_blocks(const Matrix3d& R, const Eigen::MatrixXd& noise, Eigen::MatrixXd& out) noexcept {
  for (Eigen::Index i = 0; i < noise.rows(); i += 3)
    for (Eigen::Index j = 0; j < noise.cols(); j += 3)
      out.block<3, 3>(i, j).noalias() = R * noise.block<3, 3>(i, j) * R.transpose();
}

/// Calls `call` for each foot of a set, in ascending order.
template <class Call>
void for_each(FootSet feet, int count, const Call& call) {
  for (int k = 0; k < count; ++k)
    if ((feet & foot_bit(k)) != 0) call(k);
}

}  // namespace

ContactFilter::ContactFilter(const std::vector<char>& soles, const FilterNoise& noise,
                             const Vector3d& gravity)
    : noise_(noise), gravity_(from_eigen(gravity)) {
  int at = unit_size;
  for (const char sole : soles) {
    feet_.push_back({sole != 0, at, seen_size_, {}, Mat3<double>::identity(), 0.0});
    at += sole != 0 ? 6 : 3;
    seen_size_ += sole != 0 ? 6 : 3;
  }
  const int m = seen_size_;
  P_.setZero(at, at);
  B_.setZero(at, 6);
  r_.setZero(m);
  change_.setZero(at);
  AP_.setZero(at, at);
  PHt_.setZero(at, m);
  K_ = APHt_ = PHt_;
  S_.setZero(m, m);
  N_ = turned_ = S_;
  chosen_.reserve(to_size(m));
  state_ = {Mat3<double>::identity(), Vec3<double>::zero(), Vec3<double>::zero()};
  saved_P_ = P_;  // allocates here, because ticks must not allocate
  save();
}

void ContactFilter::reset(const InertialState<double>& state, const Vector3d& b_gyro,
                          const Vector3d& b_accelerometer,
                          const Eigen::MatrixXd& covariance) noexcept {
  state_ = state;
  b_gyro_ = b_gyro;
  b_accelerometer_ = b_accelerometer;
  standing_ = 0;
  P_.setZero();
  P_.topLeftCorner<unit_size, unit_size>() = covariance;
  squared_innovation_ = 0.0;
  innovation_rows_ = 0;
  for (Foot& foot : feet_) foot.squared = 0.0;
}

/// Computes the coefficients B_ of the bias error zeta in equations (1) to (4) of the header, at
/// the state after the tick.
void ContactFilter::fill_bias_jacobian(const Matrix3d& R_before, const Vec3<double>& phi,
                                       const RotationSeries<double>& c, const Vec3<double>& f,
                                       double dt) noexcept {
  const Matrix3d R_gamma_1 = R_before * to_eigen(gamma_1(phi, c));
  const Matrix3d B_Rg = -dt * R_gamma_1;
  B_.setZero();
  B_.block<3, 3>(R, 0) = B_Rg;
  B_.block<3, 3>(v, 0) =
      skew(state_.v) * B_Rg - dt * dt * R_before * to_eigen(gamma_1_slope(phi, c, f));
  B_.block<3, 3>(p, 0) =
      skew(state_.p) * B_Rg - dt * dt * dt * R_before * to_eigen(gamma_2_slope(phi, c, f));
  B_.block<3, 3>(v, 3) = B_Rg;
  B_.block<3, 3>(p, 3) = -dt * dt * R_before * to_eigen(gamma_2(phi, c));
  for_each(standing_, feet(),
           [&](int k) { B_.block<3, 3>(at(k), 0) = skew(foot_position(k)) * B_Rg; });
}

/// Replaces the covariance P by Phi P in place, with the transition matrix Phi. The order of rows
/// ensures that each new row only uses rows that are not yet replaced.
void ContactFilter::propagate_rows(Eigen::MatrixXd& P, const Matrix3d& g,
                                   double dt) const noexcept {
  const auto rows = [&](int entry) { return P.middleRows<3>(entry); };
  const auto biases = P.middleRows<6>(gyro_bias);
  for_each(standing_, feet(),
           [&](int k) { rows(at(k)).noalias() += B_.block<3, 3>(at(k), 0) * rows(gyro_bias); });
  rows(p) += dt * rows(v);
  rows(p).noalias() += (0.5 * dt * dt * g) * rows(R);
  rows(p).noalias() += B_.middleRows<3>(p) * biases;
  rows(v).noalias() += (dt * g) * rows(R);
  rows(v).noalias() += B_.middleRows<3>(v) * biases;
  rows(R).noalias() += B_.block<3, 3>(R, 0) * rows(gyro_bias);
}

void ContactFilter::propagate(const ImuReading& reading, double dt) noexcept {
  const Vec3<double> w = from_eigen(Vector3d(reading.gyro - b_gyro_));
  const Vec3<double> f = from_eigen(Vector3d(reading.accelerometer - b_accelerometer_));
  const Matrix3d R_before = to_eigen(state_.R);
  const Vec3<double> phi = w * dt;
  state_ = strapdown(state_, w, f, gravity_, dt);
  state_.R = orthonormal(state_.R);
  fill_bias_jacobian(R_before, phi, rotation_series(phi), f, dt);

  const Matrix3d g = skew(gravity_);
  propagate_rows(P_, g, dt);
  P_.transposeInPlace();
  propagate_rows(P_, g, dt);
  // White noise of density s gives a reading the variance s^2/dt. The matrix B_ maps noise to xi.
  const double of_gyro = noise_.gyro * noise_.gyro / dt;
  const double of_accelerometer = noise_.accelerometer * noise_.accelerometer / dt;
  P_.noalias() += of_gyro * (B_.leftCols<3>().lazyProduct(B_.leftCols<3>().transpose()));
  P_.noalias() += of_accelerometer * (B_.rightCols<3>().lazyProduct(B_.rightCols<3>().transpose()));
  const auto add = [&](int entry, double density) {
    P_.diagonal().segment<3>(entry).array() += density * density * dt;
  };
  add(gyro_bias, noise_.gyro_bias);
  add(accelerometer_bias, noise_.accelerometer_bias);
  for_each(standing_, feet(), [&](int k) {
    add(at(k), noise_.slip);
    if (rows(k) == 6) add(at(k) + 3, noise_.sole_turn);
  });
}

/// Computes the innovation of a foot in r_, by equations (6) and (7).
void ContactFilter::innovate(int k, const SeenFoot& seen, int row) noexcept {
  const Foot& foot = feet_[index(k)];
  r_.segment<3>(row) = to_eigen(state_.R * seen.p - (foot.d - state_.p));
  if (!foot.sole) return;
  double angle = 0.0;
  r_.segment<3>(row + 3) = to_eigen(log_rotation(state_.R * seen.R * transposed(foot.C), angle));
}

/// Returns the cross-covariance of the differences (xi_a - xi_b) and (xi_c - xi_d).
Matrix3d ContactFilter::between(int a, int b, int c, int d) const noexcept {
  return P_.block<3, 3>(a, c) - P_.block<3, 3>(a, d) - P_.block<3, 3>(b, c) + P_.block<3, 3>(b, d);
}

/// Returns the squared innovation r^T S^-1 r of one foot without the other feet, where S is the
/// covariance of the innovation r. turned_ contains the noise of the feet in world axes. Returns a
/// negative number if S is not positive definite.
double ContactFilter::squared_alone(int k) const noexcept {
  const Foot& foot = feet_[index(k)];
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  const int m = rows(k);
  Small S = turned_.block(foot.row, foot.row, m, m);
  for (int i = 0; i < m; i += 3)
    for (int j = 0; j < m; j += 3)
      S.block<3, 3>(i, j) += between(foot.at + i, i == 0 ? p : R, foot.at + j, j == 0 ? p : R);
  const Eigen::LLT<Small> factor(S);
  if (factor.info() != Eigen::Success) return -1.0;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1> r = r_.segment(foot.row, m);
  factor.matrixL().solveInPlace(r);
  return r.squaredNorm();
}

FootSet ContactFilter::update(FootSet asked, const std::vector<SeenFoot>& seen,
                              const Eigen::MatrixXd& noise, const Eigen::VectorXd& gates,
                              bool& good) noexcept {
  good = true;
  squared_innovation_ = 0.0;
  innovation_rows_ = 0;
  FootSet out = 0;
  turn_blocks(to_eigen(state_.R), noise, turned_);
  chosen_.clear();
  for_each(asked & standing_, feet(), [&](int k) {
    innovate(k, seen[index(k)], first_seen(k));
    const double squared = feet_[index(k)].squared = squared_alone(k);
    if (!(squared >= 0.0)) good = false;
    if (!(squared <= gates[k])) {
      out |= foot_bit(k);
      return;
    }
    for (int i = 0; i < rows(k); i += 3)
      chosen_.push_back({at(k) + i, i == 0 ? int{p} : int{R}, first_seen(k) + i});
  });
  if (good && !chosen_.empty()) good = correct_by_chosen();
  return out;
}

/// Performs the Kalman update with the measurement rows of chosen_, in Joseph's form. Returns false
/// if S is not positive definite.
bool ContactFilter::correct_by_chosen() noexcept {
  const auto count = static_cast<int>(chosen_.size());
  const int m = 3 * count;
  auto PHt = PHt_.leftCols(m);
  auto S = S_.topLeftCorner(m, m), N = N_.topLeftCorner(m, m);
  for (int i = 0; i < count; ++i) {
    const Rows& row = chosen_[index(i)];
    PHt.middleCols<3>(3 * i) = P_.middleCols<3>(row.plus) - P_.middleCols<3>(row.minus);
    // Rows only move to smaller or equal indices, so that no row is overwritten before it is read.
    r_.segment<3>(3 * i) = Vector3d(r_.segment<3>(row.seen));
    for (int j = 0; j < count; ++j)
      N.block<3, 3>(3 * i, 3 * j) = turned_.block<3, 3>(row.seen, chosen_[index(j)].seen);
  }
  for (int i = 0; i < count; ++i)
    S.middleRows<3>(3 * i) = PHt.middleRows<3>(chosen_[index(i)].plus) -
                             PHt.middleRows<3>(chosen_[index(i)].minus) + N.middleRows<3>(3 * i);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(S);
  if (factor.info() != Eigen::Success) return false;
  auto K = K_.leftCols(m);
  auto r = r_.head(m);
  K = PHt;
  factor.matrixU().solveInPlace<Eigen::OnTheRight>(K);
  factor.matrixL().solveInPlace(r);
  squared_innovation_ = r.squaredNorm();
  innovation_rows_ = m;
  change_.noalias() = K * r;
  factor.matrixL().solveInPlace<Eigen::OnTheRight>(K);

  AP_ = P_;
  AP_.noalias() -= K * PHt.transpose();
  auto rest = APHt_.leftCols(m);  // K N - A P H^T, which is zero except for rounding errors
  rest.noalias() = K * N;
  for (int i = 0; i < count; ++i)
    rest.middleCols<3>(3 * i) -=
        AP_.middleCols<3>(chosen_[index(i)].plus) - AP_.middleCols<3>(chosen_[index(i)].minus);
  AP_.noalias() += rest * K.transpose();
  for (Eigen::Index j = 0; j < AP_.cols(); ++j)
    for (Eigen::Index i = 0; i <= j; ++i) P_(i, j) = P_(j, i) = 0.5 * (AP_(i, j) + AP_(j, i));
  correct();
  return true;
}

/// Applies the correction: replaces X^ by exp(change) X^, and corrects the rotations of soles and
/// the biases.
void ContactFilter::correct() noexcept {
  const Vec3<double> turn = segment(change_, R);
  const RotationSeries<double> c = rotation_series(turn);
  const Mat3<double> E = exp_matrix(turn, c), J = gamma_1(turn, c);
  state_.R = orthonormal(E * state_.R);
  state_.v = E * state_.v + J * segment(change_, v);
  state_.p = E * state_.p + J * segment(change_, p);
  b_gyro_ += change_.segment<3>(gyro_bias);
  b_accelerometer_ += change_.segment<3>(accelerometer_bias);
  for_each(standing_, feet(), [&](int k) {
    Foot& foot = feet_[index(k)];
    foot.d = E * foot.d + J * segment(change_, foot.at);
    if (!foot.sole) return;
    const Vec3<double> turned = segment(change_, foot.at + 3);
    foot.C = orthonormal(exp_matrix(turned, rotation_series(turned)) * foot.C);
  });
}

void ContactFilter::add(FootSet added, const std::vector<SeenFoot>& seen,
                        const Eigen::MatrixXd& noise) noexcept {
  added &= ~standing_;
  if (added == 0) return;
  turn_blocks(to_eigen(state_.R), noise, turned_);
  for_each(added, feet(), [&](int k) {
    Foot& foot = feet_[index(k)];
    const SeenFoot& at_unit = seen[index(k)];
    foot.d = state_.p + state_.R * at_unit.p;
    foot.C = state_.R * at_unit.R;
    for (int i = 0; i < rows(k); i += 3) {  // equation (8)
      const int from = i == 0 ? p : R;
      P_.middleRows<3>(foot.at + i) = P_.middleRows<3>(from);
      P_.middleCols<3>(foot.at + i) = P_.middleCols<3>(from);
    }
  });
  for_each(added, feet(), [&](int k) {
    for_each(added, feet(), [&](int l) {
      P_.block(at(k), at(l), rows(k), rows(l)) +=
          turned_.block(first_seen(k), first_seen(l), rows(k), rows(l));
    });
  });
  standing_ |= added;
}

void ContactFilter::doubt_velocity(double deviation) noexcept {
  P_.diagonal().segment<3>(v).array() += deviation * deviation;
}

void ContactFilter::remove(FootSet feet_to_remove) noexcept {
  for_each(feet_to_remove & standing_, feet(), [&](int k) {
    P_.middleRows(at(k), rows(k)).setZero();
    P_.middleCols(at(k), rows(k)).setZero();
  });
  standing_ &= ~feet_to_remove;
}

bool ContactFilter::is_finite() const noexcept {
  const Mat3<double>& R_now = state_.R;
  const Vec3<double> sum = R_now.c0 + R_now.c1 + R_now.c2 + state_.v + state_.p;
  double feet_sum = 0.0;
  for_each(standing_, feet(), [&](int k) {
    const Foot& foot = feet_[index(k)];
    feet_sum += dot(foot.d, foot.d) + dot(foot.C.c0 + foot.C.c1, foot.C.c2);
  });
  return to_eigen(sum).allFinite() && b_gyro_.allFinite() && b_accelerometer_.allFinite() &&
         std::isfinite(feet_sum) && P_.allFinite() && (P_.diagonal().array() >= -1e-12).all();
}

void ContactFilter::save() noexcept {
  saved_state_ = state_;
  saved_b_gyro_ = b_gyro_;
  saved_b_accelerometer_ = b_accelerometer_;
  saved_feet_ = feet_;
  saved_standing_ = standing_;
  saved_P_ = P_;
}

void ContactFilter::restore() noexcept {
  state_ = saved_state_;
  b_gyro_ = saved_b_gyro_;
  b_accelerometer_ = saved_b_accelerometer_;
  feet_ = saved_feet_;
  standing_ = saved_standing_;
  P_ = saved_P_;
}

}  // namespace burnish
