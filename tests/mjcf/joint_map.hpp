// Maps states of a burnish model to MuJoCo's coordinates of the same file.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::testing {

std::string name_in(const mjModel& model, int type, int index);

/// Map between the joints of a model and MuJoCo's. Followers and locked joints of the tree move
/// independently in MuJoCo.
class JointMap {
 public:
  /// Throws Error if the models have different joints.
  JointMap(const TreeSpec& tree, const Model& model, const mjModel& theirs);

  /// Writes qpos and qvel, the matrix B with qvel = B v, and the drift dB/dt v.
  void store(const Eigen::VectorXd& q, const Eigen::VectorXd& v, mjData& data, Eigen::MatrixXd& B,
             Eigen::VectorXd& drift) const;

 private:
  void place_locked_joints(mjData& data) const;

  const Model& model_;
  const mjModel& theirs_;
  std::vector<int> ours_;  // index of the model's joint for each of MuJoCo's joints; -1 if locked
};

}  // namespace burnish::testing
