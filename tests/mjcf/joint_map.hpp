// Joints of a tree beside those of MuJoCo's reading: where each state stands in the other.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::testing {

std::string name_in(const mjModel& model, int type, int index);

/// Places of the joints in both. Followers and held joints of the tree move by themselves in
/// MuJoCo.
class JointMap {
 public:
  /// Throws Error where the two have other joints.
  JointMap(const TreeSpec& tree, const Model& model, const mjModel& theirs);

  /// Writes qpos and qvel, the matrix B with qvel = B v and its rate of change times v.
  void store(const Eigen::VectorXd& q, const Eigen::VectorXd& v, mjData& data, Eigen::MatrixXd& B,
             Eigen::VectorXd& drift) const;

 private:
  void place_held_joints(mjData& data) const;

  const Model& model_;
  const mjModel& theirs_;
  std::vector<int> ours_;  // index of a joint of the model, -1: held
};

}  // namespace burnish::testing
