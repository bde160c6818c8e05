// Tests of the contact filter: its linear maps against finite differences and automatic
// differentiation, and its unobservable directions.
#include "estimate/contact_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <random>

#include "estimate/truth.hpp"
#include "support/autodiff.hpp"
#include "support/robots.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Point foot (0) and planar foot (1).
const std::vector<char> point_and_planar_foot = {0, 1};
constexpr FootSet both = 3;
constexpr int entries_of_xi = ContactFilter::unit_size + 9, seen_rows = 9;

template <class S>
struct State {
  InertialState<S> unit;
  Vec3<S> b_gyro, b_accelerometer;
  Vec3<S> d[2];
  Mat3<S> C;  ///< rotation of foot 1
};

State<double> state_of(const ContactFilter& filter) {
  return {filter.state(),
          from_eigen(filter.b_gyro()),
          from_eigen(filter.b_accelerometer()),
          {filter.foot_position(0), filter.foot_position(1)},
          filter.foot_rotation(1)};
}
template <class S>
State<S> lifted(const State<double>& x) {
  return {{lift<S>(x.unit.R), lift<S>(x.unit.v), lift<S>(x.unit.p)},
          lift<S>(x.b_gyro),
          lift<S>(x.b_accelerometer),
          {lift<S>(x.d[0]), lift<S>(x.d[1])},
          lift<S>(x.C)};
}

/// Returns exp(xi) X, with xi's bias entries added to the biases.
template <class S>
State<S> moved(const State<double>& from, const S* xi) {
  const auto at = [&](int entry) { return Vec3<S>{xi[entry], xi[entry + 1], xi[entry + 2]}; };
  const Vec3<S> phi = at(ContactFilter::R), turned = at(21);
  const RotationSeries<S> c = rotation_series(phi);
  const Mat3<S> E = exp_matrix(phi, c), J = gamma_1(phi, c);
  State<S> x = lifted<S>(from);
  x.unit = {E * x.unit.R, E * x.unit.v + J * at(ContactFilter::v),
            E * x.unit.p + J * at(ContactFilter::p)};
  x.b_gyro += at(ContactFilter::gyro_bias);
  x.b_accelerometer += at(ContactFilter::accelerometer_bias);
  x.d[0] = E * x.d[0] + J * at(15);
  x.d[1] = E * x.d[1] + J * at(18);
  x.C = exp_matrix(turned, rotation_series(turned)) * x.C;
  return x;
}

/// Returns xi to first order with x = exp(xi) from; biases last.
template <class S>
std::vector<S> error_of(const State<S>& x, const State<double>& from) {
  const State<S> hat = lifted<S>(from);
  const Mat3<S> E = x.unit.R * transposed(hat.unit.R);
  S angle;
  const Vec3<S> xi[8] = {log_rotation(E, angle),
                         x.unit.v - E * hat.unit.v,
                         x.unit.p - E * hat.unit.p,
                         x.b_gyro - hat.b_gyro,
                         x.b_accelerometer - hat.b_accelerometer,
                         x.d[0] - E * hat.d[0],
                         x.d[1] - E * hat.d[1],
                         log_rotation(x.C * transposed(hat.C), angle)};
  std::vector<S> result;
  for (const Vec3<S>& block : xi) result.insert(result.end(), {block.x, block.y, block.z});
  return result;
}

template <class S>
State<S> after(State<S> x, const ImuReading& reading, double dt) {
  x.unit = strapdown(x.unit, lift<S>(from_eigen(reading.gyro)) - x.b_gyro,
                     lift<S>(from_eigen(reading.accelerometer)) - x.b_accelerometer,
                     lift<S>(from_eigen(gravity)), S(dt));
  return x;
}

/// Rows of the innovation of both feet at an estimate, from observations (h, Q) with noise.
template <class S>
std::vector<S> innovation_at(const State<S>& truth, const S* noise, const State<double>& estimate) {
  const State<S> hat = lifted<S>(estimate);
  std::vector<S> result;
  const auto put = [&](const Vec3<S>& a) { result.insert(result.end(), {a.x, a.y, a.z}); };
  for (int k = 0; k < 2; ++k) {
    Vec3<S> h = transpose_times(truth.unit.R, truth.d[k] - truth.unit.p);
    h += Vec3<S>{noise[3 * k], noise[3 * k + 1], noise[3 * k + 2]};
    put(hat.unit.R * h - (hat.d[k] - hat.unit.p));
  }
  const Vec3<S> n{noise[6], noise[7], noise[8]};
  const Mat3<S> Q = exp_matrix(n, rotation_series(n)) * transpose_times(truth.unit.R, truth.C);
  S angle;
  put(log_rotation(hat.unit.R * Q * transposed(hat.C), angle));
  return result;
}

/// Derivative with respect to `size` variables at zero, by automatic differentiation.
template <class Evaluate>
MatrixXd exact(int size, const Evaluate& evaluate) {
  const Seeded x{VectorXd::Zero(size), MatrixXd::Identity(size, size)};
  const Seeded none{VectorXd::Zero(1), MatrixXd::Zero(1, size)};
  return differentiate(x, none,
                       [&](const Duals& xi, const Duals& /*none*/) { return evaluate(xi.data()); });
}
/// Derivative with respect to `size` variables at zero, by finite differences.
template <class Evaluate>
MatrixXd differences(int size, const Evaluate& evaluate) {
  constexpr double h = 1e-5;
  MatrixXd result;
  for (int k = 0; k < size; ++k) {
    VectorXd x = VectorXd::Zero(size);
    x[k] = h;
    const std::vector<double> up = evaluate(x.data());
    x[k] = -h;
    const std::vector<double> down = evaluate(x.data());
    if (k == 0) result.resize(static_cast<Eigen::Index>(up.size()), size);
    for (std::size_t i = 0; i < up.size(); ++i)
      result(static_cast<Eigen::Index>(i), k) = (up[i] - down[i]) / (2.0 * h);
  }
  return result;
}

MatrixXd random_covariance(int size, double scale, std::mt19937_64& generator) {
  MatrixXd root(size, size);
  for (double& entry : root.reshaped()) entry = normal3(generator, 1.0)[0];
  return scale * scale * (root * root.transpose() + MatrixXd::Identity(size, size));
}

/// Filter with both feet standing, observed at `seen`, and a dense covariance.
struct StandingFilter {
  explicit StandingFilter(std::uint64_t seed, const FilterNoise& noise = {})
      : generator(seed), filter(point_and_planar_foot, noise, gravity) {
    const InertialState<double> start{from_eigen(exp3(normal3(generator, 1.0))),
                                      from_eigen(normal3(generator, 1.0)),
                                      from_eigen(normal3(generator, 2.0))};
    filter.reset(start, normal3(generator, 0.05), normal3(generator, 0.2),
                 random_covariance(ContactFilter::unit_size, 0.01, generator));
    seen = {{from_eigen(normal3(generator, 0.5)), Mat3<double>::identity()},
            {from_eigen(normal3(generator, 0.5)), from_eigen(exp3(normal3(generator, 1.0)))}};
    seen_noise = random_covariance(seen_rows, 0.002, generator);
    filter.add(both, seen, seen_noise);
  }
  std::mt19937_64 generator;
  ContactFilter filter;
  std::vector<SeenFoot> seen;
  MatrixXd seen_noise;
};

bool same(const MatrixXd& a, const MatrixXd& b, double relative) {
  return (a - b).norm() <= relative * b.norm();
}

TEST(ContactFilter, Propagation_IsExactToFirstOrder) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    StandingFilter s(seed);
    const State<double> before = state_of(s.filter);
    const MatrixXd P = s.filter.covariance();
    const ImuReading reading{normal3(s.generator, 2.0), normal3(s.generator, 9.0)};
    const double dt = seed % 2 == 0 ? 1e-3 : 0.1;
    const State<double> next = after(before, reading, dt);
    s.filter.propagate(reading, dt);
    const auto transition = [&](const auto* xi) {
      return error_of(after(moved(before, xi), reading, dt), next);
    };
    const MatrixXd Phi = exact(entries_of_xi, transition);
    EXPECT_TRUE(same(differences(entries_of_xi, transition), Phi, 1e-8));
    EXPECT_TRUE(same(s.filter.covariance(), Phi * P * Phi.transpose(), 1e-12));
    EXPECT_LT((to_eigen(s.filter.state().p) - to_eigen(next.unit.p)).norm(), 1e-12);
    EXPECT_LT((to_eigen(s.filter.state().R) - to_eigen(next.unit.R)).norm(), 1e-12);
  }
}

TEST(ContactFilter, ImuNoise_EntersTheCovarianceAsDefined) {
  const FilterNoise noise{0.01, 0.1, 0.001, 0.02, 0.03, 0.05};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    StandingFilter s(seed, noise);
    const State<double> before = state_of(s.filter);
    const MatrixXd P = s.filter.covariance();
    const ImuReading reading{normal3(s.generator, 2.0), normal3(s.generator, 9.0)};
    constexpr double dt = 0.01;
    const State<double> next = after(before, reading, dt);
    s.filter.propagate(reading, dt);
    const MatrixXd Phi = exact(entries_of_xi, [&](const Dual* xi) {
      return error_of(after(moved(before, xi), reading, dt), next);
    });
    // The true readings are the measured readings less noise.
    const MatrixXd by_noise = exact(6, [&](const Dual* n) {
      State<Dual> x = lifted<Dual>(before);
      x.b_gyro += Vec3<Dual>{n[0], n[1], n[2]};
      x.b_accelerometer += Vec3<Dual>{n[3], n[4], n[5]};
      x = after(x, reading, dt);
      x.b_gyro = lift<Dual>(before.b_gyro);
      x.b_accelerometer = lift<Dual>(before.b_accelerometer);
      return error_of(x, next);
    });
    VectorXd of_reading(6), walks = VectorXd::Zero(entries_of_xi);
    of_reading << VectorXd::Constant(3, 0.01 * 0.01 / dt), VectorXd::Constant(3, 0.1 * 0.1 / dt);
    walks.segment(9, 3).setConstant(0.001 * 0.001 * dt);
    walks.segment(12, 3).setConstant(0.02 * 0.02 * dt);
    walks.segment(15, 6).setConstant(0.03 * 0.03 * dt);
    walks.segment(21, 3).setConstant(0.05 * 0.05 * dt);
    MatrixXd wanted = Phi * P * Phi.transpose();
    wanted += by_noise * of_reading.asDiagonal() * by_noise.transpose();
    wanted.diagonal() += walks;
    EXPECT_TRUE(same(s.filter.covariance(), wanted, 1e-12));
  }
}

TEST(ContactFilter, AddedFeet_GetTheCovarianceOfTheirObservation) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    StandingFilter s(seed);
    const State<double> hat = state_of(s.filter);
    const MatrixXd P = s.filter.covariance();
    // The true state differs from the estimate by xi; the feet are observed with noise.
    const MatrixXd by = exact(ContactFilter::unit_size + seen_rows, [&](const Dual* x) {
      std::vector<Dual> xi(x, x + ContactFilter::unit_size);
      xi.resize(entries_of_xi, Dual(0.0));
      State<Dual> truth = moved(hat, xi.data());
      const Dual* n = x + ContactFilter::unit_size;
      const auto noise = [&](int i) { return Vec3<Dual>{n[i], n[i + 1], n[i + 2]}; };
      for (int k = 0; k < 2; ++k)
        truth.d[k] =
            truth.unit.p +
            truth.unit.R * (lift<Dual>(s.seen[static_cast<std::size_t>(k)].p) - noise(3 * k));
      const Vec3<Dual> back = -noise(6);
      truth.C = truth.unit.R * (exp_matrix(back, rotation_series(back)) * lift<Dual>(s.seen[1].R));
      return error_of(truth, hat);
    });
    MatrixXd inputs = MatrixXd::Zero(by.cols(), by.cols());
    inputs.topLeftCorner(15, 15) = P.topLeftCorner(15, 15);
    inputs.bottomRightCorner(9, 9) = s.seen_noise;
    EXPECT_TRUE(same(P, by * inputs * by.transpose(), 1e-12));
  }
}

TEST(ContactFilter, Update_IsAKalmanUpdateWithExactDerivatives) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    StandingFilter s(seed);
    s.filter.propagate({normal3(s.generator, 1.0), normal3(s.generator, 9.0)}, 0.02);
    const State<double> hat = state_of(s.filter);
    const MatrixXd P = s.filter.covariance();
    const MatrixXd H = exact(entries_of_xi, [&](const Dual* xi) {
      const Duals none(9, Dual(0.0));
      return innovation_at(moved(hat, xi), none.data(), hat);
    });
    const auto by_xi = [&](const double* xi) {
      const std::vector<double> none(9, 0.0);
      return innovation_at(moved(hat, xi), none.data(), hat);
    };
    EXPECT_TRUE(same(differences(entries_of_xi, by_xi), H, 1e-8));
    const MatrixXd D =
        exact(9, [&](const Dual* n) { return innovation_at(lifted<Dual>(hat), n, hat); });
    const MatrixXd N = random_covariance(seen_rows, 0.003, s.generator);

    // Observations with small errors relative to the estimate.
    std::vector<SeenFoot> seen(2);
    for (int k = 0; k < 2; ++k)
      seen[static_cast<std::size_t>(k)].p = transpose_times(hat.unit.R, hat.d[k] - hat.unit.p) +
                                            from_eigen(normal3(s.generator, 1e-5));
    seen[0].R = Mat3<double>::identity();
    seen[1].R = from_eigen(exp3(normal3(s.generator, 1e-5))) * transpose_times(hat.unit.R, hat.C);
    VectorXd r(9);
    for (int k = 0; k < 2; ++k)
      r.segment<3>(3 * k) =
          to_eigen(hat.unit.R * seen[static_cast<std::size_t>(k)].p - (hat.d[k] - hat.unit.p));
    r.tail<3>() = log3(to_eigen(hat.unit.R * seen[1].R * transposed(hat.C)));

    const MatrixXd S = H * P * H.transpose() + D * N * D.transpose();
    const MatrixXd K = P * H.transpose() * S.inverse();
    const VectorXd change = K * r;
    bool good = false;
    EXPECT_EQ(s.filter.update(both, seen, N, VectorXd::Constant(2, infinity), good), 0U);
    EXPECT_TRUE(good);
    EXPECT_TRUE(same(s.filter.covariance(), P - K * H * P, 1e-9));
    EXPECT_NEAR(s.filter.squared_innovation(), r.dot(S.inverse() * r), 1e-9);
    EXPECT_EQ(s.filter.innovation_rows(), 9);
    const std::vector<double> moved_by = error_of(state_of(s.filter), hat);
    // error_of() omits J_l, whose effect is of second order.
    for (int i = 0; i < entries_of_xi; ++i)
      EXPECT_NEAR(moved_by[static_cast<std::size_t>(i)], change[i], 1e-3 * change.norm());
    const State<double> wanted = moved(hat, change.data());
    EXPECT_LT((to_eigen(wanted.d[1]) - to_eigen(s.filter.foot_position(1))).norm(), 1e-12);
    EXPECT_LT((to_eigen(wanted.C) - to_eigen(s.filter.foot_rotation(1))).norm(), 1e-12);
  }
}

/// Unobservable directions of xi: translations of the world, then rotation about the vertical.
MatrixXd unknowable() {
  MatrixXd n = MatrixXd::Zero(entries_of_xi, 4);
  for (const int entry : {int{ContactFilter::p}, 15, 18}) n.block<3, 3>(entry, 0).setIdentity();
  n(ContactFilter::R + 2, 3) = n(21 + 2, 3) = 1.0;
  return n;
}

TEST(ContactFilter, PositionAndYaw_AreNeverObserved) {
  // Without process noise, the information n^T P^-1 n along these directions stays constant for any
  // observation.
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    StandingFilter s(seed);
    const MatrixXd n = unknowable();
    const auto information = [&] {
      return MatrixXd(n.transpose() * s.filter.covariance().ldlt().solve(n));
    };
    const MatrixXd at_first = information();
    const double tilt_at_first = s.filter.covariance()(0, 0);
    for (int i = 0; i < 200; ++i) {
      s.filter.propagate({normal3(s.generator, 1.0), normal3(s.generator, 9.0)}, 0.01);
      const State<double> hat = state_of(s.filter);
      for (int k = 0; k < 2; ++k)
        s.seen[static_cast<std::size_t>(k)].p = transpose_times(hat.unit.R, hat.d[k] - hat.unit.p) +
                                                from_eigen(normal3(s.generator, 1e-3));
      s.seen[1].R =
          transpose_times(hat.unit.R, hat.C) * from_eigen(exp3(normal3(s.generator, 1e-3)));
      bool good = false;
      (void)s.filter.update(both, s.seen, s.seen_noise, VectorXd::Constant(2, infinity), good);
      ASSERT_TRUE(good);
    }
    EXPECT_TRUE(same(information(), at_first, 1e-5)) << information() << "\n\n" << at_first;
    EXPECT_LT(s.filter.covariance()(0, 0), 0.1 * tilt_at_first);  // tilt is observable
  }
}

TEST(ContactFilter, MovedAndRotatedWorld_MovesAndRotatesTheEstimate) {
  const FilterNoise noise{0.01, 0.1, 0.001, 0.02, 0.03, 0.05};
  StandingFilter a(7, noise), b(7, noise);
  const Matrix3d Z = exp3(Vector3d(0.0, 0.0, 1.9));
  const Vector3d t(100.0, -40.0, 3.0);
  // Filter b starts in a world rotated by Z and translated by t. Its xi transforms with the adjoint
  // of (Z, 0, t), which is exact.
  MatrixXd Ad = MatrixXd::Identity(15, 15);
  Matrix3d t_cross;
  t_cross << 0.0, -t.z(), t.y(), t.z(), 0.0, -t.x(), -t.y(), t.x(), 0.0;
  for (const int entry : {0, 3, 6}) Ad.block<3, 3>(entry, entry) = Z;
  Ad.block<3, 3>(6, 0) = t_cross * Z;
  const State<double> start = state_of(a.filter);
  const MatrixXd P = a.filter.covariance().topLeftCorner(15, 15);
  const Mat3<double> turn = from_eigen(Z);
  a.filter.reset(start.unit, to_eigen(start.b_gyro), to_eigen(start.b_accelerometer), P);
  b.filter.reset({turn * start.unit.R, turn * start.unit.v, turn * start.unit.p + from_eigen(t)},
                 to_eigen(start.b_gyro), to_eigen(start.b_accelerometer), Ad * P * Ad.transpose());
  a.filter.add(both, a.seen, a.seen_noise);
  b.filter.add(both, b.seen, b.seen_noise);
  for (int i = 0; i < 100; ++i) {
    const ImuReading reading{normal3(a.generator, 0.5), normal3(a.generator, 9.0)};
    const State<double> hat = state_of(a.filter);
    a.filter.propagate(reading, 0.005);
    b.filter.propagate(reading, 0.005);
    for (int k = 0; k < 2; ++k)
      a.seen[static_cast<std::size_t>(k)].p = transpose_times(hat.unit.R, hat.d[k] - hat.unit.p) +
                                              from_eigen(normal3(a.generator, 1e-3));
    bool good = false;
    (void)a.filter.update(both, a.seen, a.seen_noise, VectorXd::Constant(2, infinity), good);
    (void)b.filter.update(both, a.seen, a.seen_noise, VectorXd::Constant(2, infinity), good);
    EXPECT_NEAR(a.filter.squared_innovation(), b.filter.squared_innovation(),
                1e-6 * (1.0 + a.filter.squared_innovation()));
  }
  EXPECT_LT((Z * to_eigen(a.filter.state().R) - to_eigen(b.filter.state().R)).norm(), 1e-8);
  EXPECT_LT((Z * to_eigen(a.filter.state().v) - to_eigen(b.filter.state().v)).norm(), 1e-7);
  EXPECT_LT((Z * to_eigen(a.filter.state().p) + t - to_eigen(b.filter.state().p)).norm(), 1e-6);
  EXPECT_LT((a.filter.b_gyro() - b.filter.b_gyro()).norm(), 1e-8);
}

TEST(ContactFilter, ManyTicks_KeepTheCovariancePositiveDefinite) {
  // Four minutes at 1 kHz, in which only position and yaw become more uncertain.
  const FilterNoise noise{1e-3, 1e-2, 1e-5, 1e-4, 1e-3, 1e-3};
  StandingFilter s(11, noise);
  const MatrixXd quiet = 1e-9 * MatrixXd::Identity(seen_rows, seen_rows);
  for (int i = 0; i < 240000; ++i) {
    const State<double> hat = state_of(s.filter);
    const Vec3<double> up = transpose_times(hat.unit.R, from_eigen(Vector3d(-gravity)));
    s.filter.propagate({s.filter.b_gyro(), s.filter.b_accelerometer() + to_eigen(up)}, 1e-3);
    const State<double> next = state_of(s.filter);
    for (int k = 0; k < 2; ++k)
      s.seen[static_cast<std::size_t>(k)].p = transpose_times(next.unit.R, next.d[k] - next.unit.p);
    s.seen[1].R = transpose_times(next.unit.R, next.C);
    bool good = false;
    (void)s.filter.update(both, s.seen, quiet, VectorXd::Constant(2, infinity), good);
    ASSERT_TRUE(good) << i;
  }
  const MatrixXd& P = s.filter.covariance();
  EXPECT_TRUE(s.filter.is_finite());
  EXPECT_TRUE(P == P.transpose());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(P);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), 0.0);
  const Matrix3d R = to_eigen(s.filter.state().R);
  EXPECT_LT((R * R.transpose() - Matrix3d::Identity()).norm(), 1e-14);
}

TEST(ContactFilter, RemovedFeet_ClearTheirCovariance) {
  StandingFilter s(3);
  const MatrixXd P = s.filter.covariance();
  s.filter.remove(both);
  EXPECT_EQ(s.filter.standing(), 0U);
  EXPECT_TRUE(s.filter.covariance().bottomRows(9).isZero(0.0));
  EXPECT_TRUE(s.filter.covariance().rightCols(9).isZero(0.0));
  EXPECT_TRUE(s.filter.covariance().topLeftCorner(15, 15) == P.topLeftCorner(15, 15));
  bool good = false;
  EXPECT_EQ(s.filter.update(both, s.seen, s.seen_noise, VectorXd::Constant(2, infinity), good), 0U);
  EXPECT_TRUE(good);
  EXPECT_EQ(s.filter.innovation_rows(), 0);
}

}  // namespace
}  // namespace burnish::test
