// Chains of any length, to measure computing time over size.
#pragma once

#include <random>
#include <string>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"
#include "burnish/model/state.hpp"

namespace burnish::bench {

/// Returns a chain with links of 10 cm and 0.5 kg, and with joint axes alternately along y and z.
inline Model chain(int joints) {
  TreeSpec tree;
  tree.name = "chain";
  for (int k = 0; k <= joints; ++k) {
    LinkSpec link{.name = "link_" + std::to_string(k), .inertia = {}, .visuals = {}};
    link.inertia = {.mass = 0.5,
                    .com = Eigen::Vector3d(0.05, 0.0, 0.0),
                    .inertia_at_com = 1e-3 * Eigen::Matrix3d::Identity()};
    tree.links.push_back(link);
    if (k == 0) continue;
    JointSpec joint;
    joint.name = "joint_" + std::to_string(k);
    joint.type = JointType::Revolute;
    joint.parent_link = "link_" + std::to_string(k - 1);
    joint.child_link = link.name;
    joint.placement.translation() = Eigen::Vector3d(0.1, 0.0, 0.0);
    joint.axis = k % 2 == 0 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    tree.joints.push_back(joint);
  }
  return build_model(tree);
}

/// Returns random configurations near the stretched chain, nq x states.
inline Eigen::MatrixXd chain_configurations(const Model& model, int states) {
  std::mt19937_64 generator(1);
  Eigen::MatrixXd q(model.nq, states);
  for (int i = 0; i < states; ++i) q.col(i) = 0.1 * random_configuration(model, generator);
  return q;
}

/// Returns a contact of the tip of chain(joints) in three directions.
inline ContactSpec chain_tip(int joints) {
  return {.tool = "link_" + std::to_string(joints), .directions = Directions::linear()};
}

}  // namespace burnish::bench
