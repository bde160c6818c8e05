#include "files/here.hpp"

#include "burnish/dynamics/placement.hpp"
#include "dynamics/momentum.hpp"

namespace burnish::files {

Eigen::VectorXd center_of_mass(const Model& model, const Eigen::VectorXd& q) {
  const Tree tree(model);
  Kinematics<double> kinematics(tree);
  Momentum<double> momentum(tree);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.nv);
  update_kinematics(tree, q.data(), v.data(), kinematics);
  update_momentum(tree, kinematics, v.data(), momentum);
  Eigen::VectorXd com(3);
  com << momentum.com.x, momentum.com.y, momentum.com.z;
  return com;
}

Eigen::VectorXd placement_here(const Model& model, const Eigen::VectorXd& q,
                               const std::string& frame) {
  const Eigen::Isometry3d placement = frame_placement(model, q, frame);
  Eigen::VectorXd result(7);
  result.head<3>() = placement.translation();
  result.tail<4>() = Eigen::Quaterniond(placement.linear()).coeffs();
  return result;
}

}  // namespace burnish::files
