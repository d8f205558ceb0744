#pragma once

#include <Eigen/Core>

namespace trunk {

// Decompositions of matrices of any size are compiled here once: each source with one of its own takes
// seconds longer to build. Matrices of a fixed size stay where they are, since Eigen rounds them in another
// order.

struct SymmetricEigen {
  Eigen::VectorXd values;   // [n] ascending
  Eigen::MatrixXd vectors;  // [n][n] one of unit length in each column
};

/// Returns the eigenvalues and eigenvectors of a symmetric matrix, [n][n].
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

/// Returns x of `matrix` x = `right`; the matrix is symmetric and positive definite, [n][n].
Eigen::VectorXd solved_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Returns the inverse of a matrix, [n][n].
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix);

/// Returns orthonormal columns that span those of `matrix`, [rows][rank].
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& matrix);

/// What the columns of a matrix leave of a vector in the least squares.
struct Remainder {
  double squares;          // sum of squares that is left
  double log_determinant;  // of the columns' Gram matrix
};

/// Returns the remainder of `values` [rows] along the columns of `matrix` [rows][columns], which are
/// independent.
Remainder remainder_along(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);

/// Returns the Moore-Penrose inverse, [columns][rows] of `matrix`, which has one column or more.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

/// Returns the similarity that takes `from` to `to` in the least squares (Umeyama 1991), as a homogeneous
/// matrix; without a change of size unless `scaled`. [3][points] each.
Eigen::Matrix4d similarity_between(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, bool scaled);

}  // namespace trunk
