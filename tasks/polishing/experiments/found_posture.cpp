#include "polishing/experiments/found_posture.hpp"

#include <cmath>

#include "base/to_size.hpp"

namespace burnish::polishing {

Posture posture_of(const Model& model, const Eigen::VectorXd& q) {
  Posture posture;
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    const auto values = q.segment(joint.q_index, joint.nq);
    std::vector<double>& of_joint = posture[joint.name];
    of_joint.assign(values.begin(), values.end());
    // The configuration of these joints contains the cosine and sine of an angle; a posture
    // contains the angle.
    if (joint.kind == JointKind::Continuous || joint.kind == JointKind::Planar) {
      const Eigen::Index cosine = joint.nq - 2;
      of_joint.resize(to_size(cosine));
      of_joint.push_back(std::atan2(values[cosine + 1], values[cosine]));
    }
  }
  return posture;
}

void start_from(const Eigen::VectorXd& q, Robot& robot, Task& task) {
  static const std::string found = "found_by_experiment";
  robot.postures[found] = posture_of(robot.model, q);
  task.posture = found;
}

}  // namespace burnish::polishing
