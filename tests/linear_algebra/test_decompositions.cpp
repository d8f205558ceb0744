#include "linear_algebra/decompositions.hpp"
#include "support/catch.hpp"

using namespace trunk;

TEST_CASE("A symmetric matrix is taken apart and solved", "[linear_algebra][unit]") {
  Eigen::MatrixXd a(3, 3);
  a << 4.0, 1.0, 0.5, 1.0, 3.0, -0.25, 0.5, -0.25, 2.0;
  const SymmetricEigen eigen = symmetric_eigen(a);
  CHECK(eigen.values[0] < eigen.values[1]);
  CHECK(eigen.values[1] < eigen.values[2]);
  CHECK((a * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm() < 1e-14);
  CHECK((eigen.vectors.transpose() * eigen.vectors - Eigen::Matrix3d::Identity()).norm() < 1e-14);
  const Eigen::Vector3d right(1.0, -2.0, 3.0);
  CHECK((a * solved_symmetric(a, right) - right).norm() < 1e-14);
}

TEST_CASE("The pseudo-inverse of independent columns undoes them", "[linear_algebra][unit]") {
  Eigen::MatrixXd a(4, 2);
  a << 1.0, 2.0, 0.0, 1.0, -1.0, 3.0, 2.0, 0.5;
  CHECK((pseudo_inverse(a) * a - Eigen::Matrix2d::Identity()).norm() < 1e-14);
}

TEST_CASE("The similarity between two sets of points is found with and without a change of size",
          "[linear_algebra][unit]") {
  Eigen::Matrix3Xd from(3, 4);
  from << 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 3.0;
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  const Eigen::Matrix3Xd to = (1.5 * quarter_turn * from).colwise() + Eigen::Vector3d(1.0, 2.0, 3.0);
  const Eigen::Matrix4d scaled = similarity_between(from, to, true);
  CHECK((scaled.topLeftCorner<3, 3>() - 1.5 * quarter_turn).norm() < 1e-13);
  CHECK((scaled.topRightCorner<3, 1>() - Eigen::Vector3d(1.0, 2.0, 3.0)).norm() < 1e-13);
  const Eigen::Matrix4d rigid = similarity_between(from, to, false);
  CHECK((rigid.topLeftCorner<3, 3>() - quarter_turn).norm() < 1e-13);
}
