// Tests of the solver's dense kernels against Eigen, for sizes around the vector and tile widths.
#include "solver/dense.hpp"

#include <gtest/gtest.h>

#include "base/decomposition.hpp"
#include "burnish/base/views.hpp"
#include "solver/buffer.hpp"

namespace burnish::dense {
namespace {

/// Matrix in padded memory: random entries, NaN in the padding.
struct PaddedMatrix {
  PaddedMatrix(int rows, int columns, bool padding_is_nan = true)
      : stride(round_up(columns)),
        memory(static_cast<std::size_t>(round_up(rows) * stride + spare + lanes)) {
    for (int i = 0; i < round_up(rows) * stride; ++i)
      memory.data()[i] = padding_is_nan ? std::nan("") : 0.0;
    matrix(rows, columns) = RowMatrix::Random(rows, columns);
  }
  Eigen::Map<RowMatrix, Eigen::Unaligned, Eigen::OuterStride<>> matrix(int rows, int columns) {
    return {memory.data(), rows, columns, Eigen::OuterStride<>(stride)};
  }
  double* data() { return memory.data(); }
  int stride;
  Buffer memory;
};

double error(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const double largest = (a - b).cwiseAbs().maxCoeff();
  return std::isnan(largest) ? 1e300 : largest;
}

TEST(Dense, Product_EqualsEigenForEverySize) {
  for (int m = 1; m <= 19; ++m)
    for (const int n : {1, 3, 4, 7, 8, 9, 16, 23, 30}) {
      const int count = 1 + (m * n) % 13;
      PaddedMatrix a(count, m);
      PaddedMatrix b(count, n);
      PaddedMatrix c(m, n, false);
      const Eigen::MatrixXd before = c.matrix(m, n);
      const Eigen::MatrixXd ab = a.matrix(count, m).transpose() * b.matrix(count, n);
      product<Update::Add>({a.data(), a.stride, 1}, {b.data(), b.stride}, count, m, n,
                           {c.data(), c.stride});
      EXPECT_LT(error(c.matrix(m, n), before + ab), 1e-13) << m << " x " << n;
      product<Update::Subtract>({a.data(), a.stride, 1}, {b.data(), b.stride}, count, m, n,
                                {c.data(), c.stride});
      EXPECT_LT(error(c.matrix(m, n), before), 1e-13) << m << " x " << n;
      product<Update::Set>({a.data(), a.stride, 1}, {b.data(), b.stride}, count, m, n,
                           {c.data(), c.stride});
      EXPECT_LT(error(c.matrix(m, n), ab), 1e-13) << m << " x " << n;
    }
}

TEST(Dense, LowerProduct_EqualsEigenBelowTheDiagonal) {
  for (int n = 1; n <= 40; ++n) {
    const int count = 1 + n % 7;
    PaddedMatrix a(count, n);
    PaddedMatrix b(count, n);
    PaddedMatrix c(n, n, false);
    const Eigen::MatrixXd wanted =
        c.matrix(n, n) + a.matrix(count, n).transpose() * b.matrix(count, n);
    lower_product<Update::Add>({a.data(), a.stride, 1}, {b.data(), b.stride}, count, n,
                               {c.data(), c.stride});
    const Eigen::MatrixXd difference = c.matrix(n, n) - wanted;
    EXPECT_LT(difference.triangularView<Eigen::Lower>().toDenseMatrix().cwiseAbs().maxCoeff(),
              1e-13)
        << n;
  }
}

TEST(Dense, MirrorAndTranspose_MoveEveryEntry) {
  for (int n = 1; n <= 30; ++n) {
    PaddedMatrix a(n, n);
    PaddedMatrix b(n, n, false);
    mirror_lower({a.data(), a.stride}, {0, n}, {b.data(), b.stride});
    const Eigen::MatrixXd wanted = a.matrix(n, n).selfadjointView<Eigen::Lower>();
    EXPECT_EQ(error(b.matrix(n, n), wanted), 0.0) << n;
    mirror_lower({a.data(), a.stride}, {0, n}, {a.data(), a.stride});
    EXPECT_EQ(error(a.matrix(n, n), wanted), 0.0) << n;
    const int m = 1 + (3 * n) % 11;
    PaddedMatrix c(m, n);
    PaddedMatrix d(n, m, false);
    transpose_copy({c.data(), c.stride}, m, n, {d.data(), d.stride});
    EXPECT_EQ(error(d.matrix(n, m), c.matrix(m, n).transpose()), 0.0) << m << " x " << n;
  }
}

TEST(Dense, PartialCholeskyAndGains_EqualEigen) {
  for (int nu = 1; nu <= 34; ++nu) {
    const int n = 1 + (5 * nu) % 23;
    PaddedMatrix y(nu, nu + n);
    const Eigen::MatrixXd root = Eigen::MatrixXd::Random(nu, nu);
    const Eigen::MatrixXd Q = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(nu, nu);
    y.matrix(nu, nu + n).leftCols(nu) = Q;
    const Eigen::MatrixXd Z = y.matrix(nu, nu + n).rightCols(n);
    std::vector<double> inverse(static_cast<std::size_t>(nu));
    EXPECT_EQ(partial_cholesky(y.data(), y.stride, nu, {0, nu + n}, inverse.data()), -1);
    EXPECT_LT(error(y.matrix(nu, nu + n).rightCols(n), solve_positive_half(Q, Z)), 1e-10);
    PaddedMatrix x(nu, n, false);
    solve_gains({y.data(), y.stride, inverse.data()}, {y.data() + nu, y.stride}, nu, n,
                {x.data(), x.stride});
    const double scale = solve_positive(Q, Z).cwiseAbs().maxCoeff();
    EXPECT_LT(error(x.matrix(nu, n), -solve_positive(Q, Z)), 1e-10 * scale) << nu;
  }
}

TEST(Dense, PartialCholesky_NamesTheNonPositivePivot) {
  for (const int bad : {0, 3, 8, 11}) {
    PaddedMatrix y(12, 15);
    y.matrix(12, 15).leftCols(12).setIdentity();
    y.matrix(12, 15)(bad, bad) = bad == 3 ? std::nan("") : -1.0;
    double inverse[12];
    EXPECT_EQ(partial_cholesky(y.data(), y.stride, 12, {0, 15}, inverse), bad);
  }
}

}  // namespace
}  // namespace burnish::dense
