#include "linear_algebra/decompositions.hpp"

#include <Eigen/Dense>

namespace trunk {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd solved_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

Eigen::Matrix4d similarity_between(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, bool scaled) {
  return Eigen::umeyama(from, to, scaled);
}

}  // namespace trunk
