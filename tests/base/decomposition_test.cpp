// Tests of eigenvalues, null spaces, least squares and solutions with positive definite matrices.
#include "base/decomposition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace burnish {
namespace {

Eigen::MatrixXd positive(int n) {
  const Eigen::MatrixXd root = Eigen::MatrixXd::Random(n, n);
  return root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
}

TEST(Decomposition, SymmetricEigen_AscendsAndRebuildsTheMatrix) {
  for (const int n : {1, 3, 6, 20}) {
    const Eigen::MatrixXd A = positive(n);
    const SymmetricEigen eigen = symmetric_eigen(A);
    EXPECT_LE((eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose() - A).norm(),
              1e-12 * A.norm());
    for (int i = 1; i < n; ++i) EXPECT_LE(eigen.values[i - 1], eigen.values[i]);
  }
}

TEST(Decomposition, SymmetricEigenOfNan_IsNotFinite) {
  for (const int n : {1, 2, 6}) {
    Eigen::MatrixXd A = positive(n);
    A(n - 1, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(symmetric_eigen(A).values.allFinite()) << n;
  }
}

TEST(Decomposition, LeastSquares_HasMinimalResidualAndMinimalNorm) {
  const Eigen::MatrixXd tall = Eigen::MatrixXd::Random(9, 4), B = Eigen::MatrixXd::Random(9, 2);
  EXPECT_LE((tall.transpose() * (tall * least_squares(tall, B) - B)).norm(), 1e-12);
  const Eigen::MatrixXd wide = Eigen::MatrixXd::Random(3, 8);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(3), x = least_squares(wide, b);
  EXPECT_LE((wide * x - b).norm(), 1e-12);
  EXPECT_LE((null_space(wide).transpose() * x).norm(), 1e-12);
  Eigen::MatrixXd twice(4, 8);
  twice << wide, wide.row(0);
  Eigen::VectorXd same(4);
  same << b, b[0];
  EXPECT_LE((least_squares(twice, same) - x).norm(), 1e-12)
      << "a duplicated row must not change the solution";
}

TEST(Decomposition, NullSpace_IsOrthonormalAndMapsToZero) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Random(5, 9);
  A.row(4) = A.row(0) - 2.0 * A.row(1);
  const Eigen::MatrixXd N = null_space(A);
  EXPECT_EQ(N.cols(), 5);
  EXPECT_LE((A * N).norm(), 1e-12);
  EXPECT_LE((N.transpose() * N - Eigen::MatrixXd::Identity(5, 5)).norm(), 1e-12);
  EXPECT_EQ(null_space(positive(4)).cols(), 0);
}

TEST(Decomposition, SolutionWithIndefiniteMatrix_IsNan) {
  const Eigen::MatrixXd A = positive(7), B = Eigen::MatrixXd::Random(7, 3);
  EXPECT_LE((A * solve_positive(A, B) - B).norm(), 1e-11);
  const Eigen::MatrixXd half = solve_positive_half(A, B);
  EXPECT_LE((half.transpose() * half - B.transpose() * solve_positive(A, B)).norm(), 1e-10);
  for (const double entry : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    Eigen::MatrixXd bad = A;
    bad(6, 6) = entry;
    EXPECT_TRUE(solve_positive(bad, B).array().isNaN().all());
    EXPECT_TRUE(solve_positive_half(bad, B).array().isNaN().all());
  }
}

TEST(Decomposition, DampedStep_EqualsAugmentedLeastSquares) {
  const Eigen::MatrixXd J = Eigen::MatrixXd::Random(6, 9);
  const Eigen::VectorXd damping = Eigen::VectorXd::LinSpaced(6, 0.1, 0.6);
  const Eigen::VectorXd error = Eigen::VectorXd::Random(6);
  // The shortest (x, r) with J x + sqrt(damping) r = error minimizes |x|^2 + |r|^2.
  Eigen::MatrixXd both(6, 15);
  both << J, Eigen::MatrixXd(damping.cwiseSqrt().asDiagonal());
  const Eigen::VectorXd wanted = least_squares(both, error);
  EXPECT_LE((damped_step(J, damping, error) - wanted.head(9)).norm(), 1e-12);
}

}  // namespace
}  // namespace burnish
