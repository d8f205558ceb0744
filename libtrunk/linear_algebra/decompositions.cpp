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

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) {
  return matrix.inverse();
}

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& matrix) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  return qr.householderQ() * Eigen::MatrixXd::Identity(matrix.rows(), qr.rank());
}

Remainder remainder_along(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(matrix);
  const Eigen::VectorXd rotated = qr.householderQ().adjoint() * values;
  const Eigen::Index columns = matrix.cols();
  return {rotated.tail(rotated.size() - columns).squaredNorm(),
          2.0 * qr.matrixQR().diagonal().head(columns).cwiseAbs().array().log().sum()};
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

Eigen::Matrix4d similarity_between(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, bool scaled) {
  return Eigen::umeyama(from, to, scaled);
}

}  // namespace trunk
