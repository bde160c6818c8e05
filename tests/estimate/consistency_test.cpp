// Consistency of the filter: errors and innovations against the covariance that it claims, over
// many seeds.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "estimate/chi_square.hpp"
#include "estimate/contact_filter.hpp"
#include "estimate/truth.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int seeds = 60;

/// Expects the mean squared error over runs, each with `dof` degrees of freedom, within bounds that
/// it exceeds once in ten thousand cases.
void expect_square(double mean, int dof, int runs, const std::string& label) {
  const int total_dof = dof * runs;
  const double low = chi_square_quantile(total_dof, 0.5e-4) / runs,
               high = chi_square_quantile(total_dof, 1.0 - 0.5e-4) / runs;
  EXPECT_GT(mean, low) << label << ": the covariance is too large; wanted " << dof;
  EXPECT_LT(mean, high) << label << ": the covariance is too small; wanted " << dof;
  ::testing::Test::RecordProperty(label, std::to_string(mean / dof));
}

TEST(ChiSquare, Quantiles_EqualPublishedTables) {
  // Abramowitz and Stegun, table 26.8.
  EXPECT_NEAR(chi_square_quantile(1, 0.95), 3.84146, 1e-5);
  EXPECT_NEAR(chi_square_quantile(3, 0.99), 11.3449, 1e-4);
  EXPECT_NEAR(chi_square_quantile(6, 0.001), 0.381067, 1e-6);
  EXPECT_NEAR(chi_square_quantile(30, 0.5), 29.3360, 1e-4);
  EXPECT_NEAR(chi_square_quantile(100, 0.999), 149.449, 1e-3);
  for (const int dof : {1, 2, 3, 6, 12, 500})
    for (const double probability : {1e-4, 0.3, 0.9999})
      EXPECT_NEAR(chi_square_share(dof, chi_square_quantile(dof, probability)), probability, 1e-8);
}

/// Feet that stand and step, and a base that moves above them.
struct Scenario {
  std::string name;
  std::vector<char> soles;
  PoseOverTime base;
  std::function<bool(int, double)> stands;
  std::function<Vector3d(int, double)> touchdown;  ///< position at which the foot touches down
};

Scenario standing_on_soles() {
  Pose start;
  start.p = {0.0, 0.0, 1.0};
  return {"soles",
          {1, 1},
          swaying(start),
          [](int, double) { return true; },
          [](int k, double) { return Vector3d(0.0, k == 0 ? 0.1 : -0.1, 0.0); }};
}

/// Trot on point feet: two feet at a time, a step of 0.25 s, 0.4 m/s, turning.
Scenario trotting_on_point_feet() {
  const auto base = [](double t) {
    const double w = 2.0 * M_PI * 2.0;
    Pose pose;
    pose.R = exp3(Vector3d(0.0, 0.0, 0.3 * t)) *
             exp3(Vector3d(0.03 * (1.0 - std::cos(w * t)),
                           0.02 * std::sin(0.5 * w * t) * t / (1.0 + t), 0.0));
    pose.p = Vector3d(0.4 * t + 0.01 * std::sin(w * t), 0.1 * t * t / (1.0 + t),
                      0.35 + 0.01 * (1.0 - std::cos(w * t)));
    return pose;
  };
  const auto stands = [](int k, double t) {
    const bool first = k == 0 || k == 3;
    const double phase = t / 0.5 - std::floor(t / 0.5);
    return first ? phase < 0.55 : phase >= 0.5 || phase < 0.05;
  };
  const auto touchdown = [base](int k, double t) {
    const Pose pose = base(t);
    const Vector3d hip((k < 2 ? 0.2 : -0.2) + 0.05, k % 2 == 0 ? 0.12 : -0.12, -0.35);
    return Vector3d(pose.p + pose.R * hip);
  };
  return {"point_feet", {0, 0, 0, 0}, base, stands, touchdown};
}

/// One run of the true system and of the filter.
class Trial {
 public:
  /// `noise_scale` scales the noise that the filter assumes, relative to the true noise.
  Trial(const Scenario& scenario, std::uint64_t seed, double dt, double noise_scale = 1.0)
      : scenario_(&scenario),
        dt_(dt),
        generator_(seed),
        filter(scenario.soles, scaled(noise_, noise_scale), gravity),
        imu_{noise_, dt, &generator_, normal3(generator_, bias_g_), normal3(generator_, bias_a_)},
        feet_(scenario.soles.size()),
        seen_(scenario.soles.size()) {
    N_ = 1e-8 * MatrixXd::Identity(filter.seen_size(), filter.seen_size());
    for (Eigen::Index i = 0; i + 1 < N_.rows(); ++i) N_(i, i + 1) = N_(i + 1, i) = 4e-9;
    root_ = N_.llt().matrixL();
    VectorXd sigma(15);
    sigma << VectorXd::Constant(3, 0.03), VectorXd::Constant(3, 0.1), VectorXd::Constant(3, 0.02),
        VectorXd::Constant(3, bias_g_), VectorXd::Constant(3, bias_a_);
    // The true state is exp(xi) times the estimate.
    const Pose at = scenario.base(0.0);
    const Vector3d v = velocity_at(scenario.base, 0.0);
    const Matrix3d back = exp3(-normal3(generator_, 0.03));
    const auto shifted = [&](const Vector3d& x, double deviation) {
      return from_eigen(Vector3d(back * x + normal3(generator_, deviation)));
    };
    const InertialState<double> start{from_eigen(Matrix3d(back * at.R)), shifted(v, 0.1),
                                      shifted(at.p, 0.02)};
    filter.reset(start, Vector3d::Zero(), Vector3d::Zero(),
                 MatrixXd(sigma.cwiseAbs2().asDiagonal()));
  }

  /// Advances from t to t + dt.
  void tick(double t) {
    filter.propagate(imu_.read(exact_reading(scenario_->base, t, dt_)), dt_);
    FootSet standing = 0;
    for (std::size_t i = 0; i < feet_.size(); ++i) {
      const int k = static_cast<int>(i);
      Foot& foot = feet_[i];
      if (!scenario_->stands(k, t + dt_)) {
        foot.down = false;
        continue;
      }
      standing |= foot_bit(k);
      if (foot.down) {
        foot.d += normal3(generator_, noise_.slip * std::sqrt(dt_));
        foot.C = exp3(normal3(generator_, noise_.sole_turn * std::sqrt(dt_))) * foot.C;
      } else {
        foot = {true, scenario_->touchdown(k, t + dt_), exp3(normal3(generator_, 0.1))};
      }
    }
    observe(t + dt_);
    filter.remove(filter.standing() & ~standing);
    bool good = false;
    (void)filter.update(standing, seen_, N_, VectorXd::Constant(filter.feet(), infinity), good);
    if (!good) throw Error("no update");
    squared_innovations += filter.squared_innovation();
    innovation_rows += filter.innovation_rows();
    filter.add(standing, seen_, N_);
  }

  /// Returns xi with true state = exp(xi) estimate; entries of feet in the air are zero.
  VectorXd error(double t) const {
    const Pose at = scenario_->base(t);
    const InertialState<double>& x = filter.state();
    const Matrix3d E = at.R * to_eigen(x.R).transpose();
    VectorXd xi = VectorXd::Zero(filter.size());
    const Vector3d turn = log3(E);
    const Vec3<double> phi = from_eigen(turn);
    const Matrix3d J_inverse = to_eigen(gamma_1(phi, rotation_series(phi))).inverse();
    const auto shift = [&](const Vector3d& truth, const Vec3<double>& estimate) {
      return Vector3d(J_inverse * (truth - E * to_eigen(estimate)));
    };
    xi.segment<3>(ContactFilter::R) = turn;
    xi.segment<3>(ContactFilter::v) = shift(velocity_at(scenario_->base, t), x.v);
    xi.segment<3>(ContactFilter::p) = shift(at.p, x.p);
    xi.segment<3>(ContactFilter::gyro_bias) = imu_.b_gyro - filter.b_gyro();
    xi.segment<3>(ContactFilter::accelerometer_bias) =
        imu_.b_accelerometer - filter.b_accelerometer();
    for (int k = 0; k < filter.feet(); ++k) {
      if ((filter.standing() & foot_bit(k)) == 0) continue;
      const Foot& foot = feet_[static_cast<std::size_t>(k)];
      xi.segment<3>(filter.at(k)) = shift(foot.d, filter.foot_position(k));
      if (filter.rows(k) == 6)
        xi.segment<3>(filter.at(k) + 3) =
            log3(foot.C * to_eigen(filter.foot_rotation(k)).transpose());
    }
    return xi;
  }

  /// Returns the observable functions of xi: they are invariant to translations of the world and to
  /// rotations about the vertical.
  MatrixXd observable() const {
    std::vector<std::pair<int, int>> rows = {{0, -1}, {1, -1}};
    for (const int first : {int{ContactFilter::v}, int{ContactFilter::gyro_bias},
                            int{ContactFilter::accelerometer_bias}})
      for (int i = 0; i < 3; ++i) rows.emplace_back(first + i, -1);
    for (int k = 0; k < filter.feet(); ++k) {
      if ((filter.standing() & foot_bit(k)) == 0) continue;
      for (int i = 0; i < filter.rows(k); ++i)
        rows.emplace_back(filter.at(k) + i,
                          i < 3 ? ContactFilter::p + i : ContactFilter::R + i - 3);
    }
    MatrixXd T = MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), filter.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      T(static_cast<Eigen::Index>(i), rows[i].first) = 1.0;
      if (rows[i].second >= 0) T(static_cast<Eigen::Index>(i), rows[i].second) = -1.0;
    }
    return T;
  }

 private:
  static FilterNoise scaled(const FilterNoise& noise, double factor) {
    return {factor * noise.gyro,      factor * noise.accelerometer,
            factor * noise.gyro_bias, factor * noise.accelerometer_bias,
            factor * noise.slip,      factor * noise.sole_turn};
  }
  struct Foot {
    bool down = false;
    Vector3d d = Vector3d::Zero();
    Matrix3d C = Matrix3d::Identity();
  };
  void observe(double t) {
    const Pose at = scenario_->base(t);
    VectorXd n(N_.rows());
    for (double& entry : n) entry = normal3(generator_, 1.0)[0];
    n = root_ * n;
    for (std::size_t i = 0; i < feet_.size(); ++i) {
      const int k = static_cast<int>(i), row = filter.first_seen(k);
      seen_[i].p = from_eigen(Vector3d(at.R.transpose() * (feet_[i].d - at.p) + n.segment<3>(row)));
      Matrix3d Q = at.R.transpose() * feet_[i].C;
      if (filter.rows(k) == 6) Q = exp3(n.segment<3>(row + 3)) * Q;
      seen_[i].R = from_eigen(Q);
    }
  }

  const Scenario* scenario_;
  double dt_;
  std::mt19937_64 generator_;
  FilterNoise noise_{2e-3, 2e-2, 1e-4, 1e-3, 2e-3, 3e-3};
  double bias_g_ = 0.01, bias_a_ = 0.1;

 public:
  ContactFilter filter;
  double squared_innovations = 0.0;
  int innovation_rows = 0;

 private:
  NoisyImu imu_;
  std::vector<Foot> feet_;
  std::vector<SeenFoot> seen_;
  MatrixXd N_, root_;
};

class FilterConsistency : public ::testing::TestWithParam<int> {};

TEST_P(FilterConsistency, ErrorsAndInnovations_MatchTheCovariance) {
  const Scenario scenario = GetParam() == 0 ? standing_on_soles() : trotting_on_point_feet();
  constexpr double dt = 0.005;
  const std::vector<int> check_ticks = {20, 150, 400, 800};  // ticks
  std::vector<double> squares(check_ticks.size(), 0.0), all_squares(check_ticks.size(), 0.0);
  std::vector<int> dof(check_ticks.size(), 0), all_freedom(check_ticks.size(), 0);
  double innovations = 0.0;
  long rows = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Trial run(scenario, static_cast<std::uint64_t>(seed), dt);
    std::size_t sample = 0;
    for (int tick = 0; tick < check_ticks.back(); ++tick) {
      run.tick(tick * dt);
      if (tick + 1 != check_ticks[sample]) continue;
      const VectorXd xi = run.error((tick + 1) * dt);
      const MatrixXd T = run.observable();
      const auto square = [&](const MatrixXd& by) {
        const VectorXd e = by * xi;
        const MatrixXd P = by * run.filter.covariance() * by.transpose();
        return e.dot(P.ldlt().solve(e));
      };
      squares[sample] += square(T) / seeds;
      dof[sample] = static_cast<int>(T.rows());
      // Adds the unobservable position and yaw, which drift as the covariance claims.
      MatrixXd whole(T.rows() + 4, T.cols());
      whole.setZero();
      whole.topRows(T.rows()) = T;
      whole.block<3, 3>(T.rows(), ContactFilter::p).setIdentity();
      whole(T.rows() + 3, ContactFilter::R + 2) = 1.0;
      all_squares[sample] += square(whole) / seeds;
      all_freedom[sample] = static_cast<int>(whole.rows());
      ++sample;
    }
    innovations += run.squared_innovations;
    rows += run.innovation_rows;
  }
  for (std::size_t i = 0; i < check_ticks.size(); ++i) {
    const std::string at = "_at_" + std::to_string(check_ticks[i]);
    expect_square(squares[i], dof[i], seeds, scenario.name + "_observable" + at);
    expect_square(all_squares[i], all_freedom[i], seeds, scenario.name + "_all" + at);
  }
  // The mean of white innovations deviates by sqrt(2/rows).
  const double bound = 4.0 * std::sqrt(2.0 / static_cast<double>(rows));
  EXPECT_NEAR(innovations / static_cast<double>(rows), 1.0, bound) << rows << " rows";
  RecordProperty(scenario.name + "_innovations",
                 std::to_string(innovations / static_cast<double>(rows)));
}

TEST(ConsistencyCheck, WrongNoiseLevel_IsDetected) {
  const Scenario scenario = standing_on_soles();
  for (const double noise_scale : {0.5, 2.0}) {
    double square = 0.0;
    int dof = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      Trial run(scenario, static_cast<std::uint64_t>(seed), 0.005, noise_scale);
      for (int tick = 0; tick < 150; ++tick) run.tick(0.005 * tick);
      const MatrixXd T = run.observable();
      const VectorXd e = T * run.error(150 * 0.005);
      square += e.dot((T * run.filter.covariance() * T.transpose()).ldlt().solve(e)) / seeds;
      dof = static_cast<int>(T.rows());
    }
    const double bound =
        chi_square_quantile(dof * seeds, noise_scale < 1.0 ? 1.0 - 1e-9 : 1e-9) / seeds;
    EXPECT_EQ(square > bound, noise_scale < 1.0) << square << " " << bound;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, FilterConsistency, ::testing::Values(0, 1));

}  // namespace
}  // namespace burnish::test
