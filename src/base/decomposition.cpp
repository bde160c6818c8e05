#include "base/decomposition.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <limits>

namespace burnish {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.completeOrthogonalDecomposition().solve(B);
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& A) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A.transpose());
  const Eigen::MatrixXd Q = qr.householderQ();
  return Q.rightCols(A.cols() - qr.rank());
}

namespace {

/// Returns solve(factor) for the Cholesky factor of A, or NaN if A is not positive definite. Eigen
/// does not report a NaN in A as a failure, so the diagonal of the factor is checked too.
template <class Solve>
Eigen::MatrixXd by_factor(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, Solve&& solve) {
  const Eigen::LLT<Eigen::MatrixXd> factor(A);
  if (factor.info() == Eigen::Success && factor.matrixLLT().diagonal().allFinite())
    return solve(factor);
  return Eigen::MatrixXd::Constant(A.rows(), B.cols(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Eigen::MatrixXd solve_positive_half(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return by_factor(
      A, B, [&](const auto& factor) -> Eigen::MatrixXd { return factor.matrixL().solve(B); });
}

Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return by_factor(A, B, [&](const auto& factor) -> Eigen::MatrixXd { return factor.solve(B); });
}

Eigen::VectorXd damped_step(const Eigen::MatrixXd& J, const Eigen::VectorXd& damping,
                            const Eigen::VectorXd& error) {
  Eigen::MatrixXd A = J * J.transpose();
  A += damping.asDiagonal();
  return J.transpose() * A.ldlt().solve(error);
}

}  // namespace burnish
