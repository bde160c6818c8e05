// Decompositions of matrices of any size. Eigen's are templates that take a compiler seconds
// wherever they are used: here they are compiled once, for what is not done in every tick.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// A = vectors diag(values) vectors^T, the values ascending and the columns of unit length.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// Of a symmetric A (n x n), of which the lower triangle is read; not finite where that is not.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

/// X (n x k) that minimises |A X - B| column by column, A m x n, B m x k; of several the shortest.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// Orthonormal columns that span all x with A x = 0 (to rounding), A m x n: n less its rank.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A);

/// A^-1 B (n x k) of a symmetric positive definite A (n x n), of which the lower triangle is read;
/// NaN where it is indefinite or not finite.
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// L^-1 B, where A = L L^T: half of that.
Eigen::MatrixXd solve_positive_half(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// x = J^T (J J^T + diag(damping))^-1 error: the step of damped least squares towards J x = error,
/// J m x n. `damping` (m) is above zero where rows of J may depend on each other.
Eigen::VectorXd damped_step(const Eigen::MatrixXd& J, const Eigen::VectorXd& damping,
                            const Eigen::VectorXd& error);

}  // namespace burnish
