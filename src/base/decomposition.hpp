// Decompositions of matrices of any size, for code outside the control tick. Eigen's templates take
// seconds to compile in every source file that uses them. Here they are compiled once.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// Eigendecomposition A = vectors diag(values) vectors^T. The values are ascending, and the columns
/// of `vectors` have unit length.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// Returns the eigendecomposition of a symmetric A (n x n). Only the lower triangle of A is read.
/// The result is not finite if A is not finite.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

/// Returns the X (n x k) that minimises |A X - B| column by column, for A (m x n) and B (m x k). If
/// the minimiser is not unique, returns the X of minimum norm.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// Returns an orthonormal basis, as columns, of the null space of A (m x n). The number of columns
/// is n minus the numerical rank of A.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A);

/// Returns A^-1 B (n x k) for a symmetric positive definite A (n x n). Only the lower triangle of A
/// is read. All entries are NaN if A is not positive definite or not finite.
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// Returns L^-1 B for the Cholesky factor L of A = L L^T. Conditions on A: see solve_positive().
Eigen::MatrixXd solve_positive_half(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// Returns x = J^T (J J^T + diag(damping))^-1 error, the damped least-squares step for J x = error,
/// with J (m x n) and `damping` (m entries). If rows of J may be linearly dependent, `damping` must
/// be positive at these rows.
Eigen::VectorXd damped_step(const Eigen::MatrixXd& J, const Eigen::VectorXd& damping,
                            const Eigen::VectorXd& error);

}  // namespace burnish
