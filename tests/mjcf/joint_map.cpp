#include "mjcf/joint_map.hpp"

#include <algorithm>
#include <set>

#include "burnish/base/error.hpp"

namespace burnish::testing {
namespace {

/// Returns the tree's joint for each of MuJoCo's joints: by its name, or the next one that the file
/// does not name.
std::vector<std::string> joints_of(const TreeSpec& tree, const mjModel& theirs) {
  std::set<std::string> stated;
  for (int j = 0; j < theirs.njnt; ++j) stated.insert(name_in(theirs, mjOBJ_JOINT, j));
  std::vector<std::string> unnamed;
  for (const JointSpec& joint : tree.joints)
    if (joint.type != JointType::Fixed && !stated.contains(joint.name))
      unnamed.push_back(joint.name);
  std::vector<std::string> names;
  auto next = unnamed.begin();
  for (int j = 0; j < theirs.njnt; ++j) {
    const std::string name = name_in(theirs, mjOBJ_JOINT, j);
    if (name.empty() && next == unnamed.end()) throw Error("MuJoCo has more joints");
    names.push_back(name.empty() ? *next++ : name);
  }
  if (next != unnamed.end()) throw Error("MuJoCo has fewer joints");
  return names;
}

}  // namespace

std::string name_in(const mjModel& model, int type, int index) {
  const char* name = mj_id2name(&model, type, index);
  return name == nullptr ? "" : name;
}

JointMap::JointMap(const TreeSpec& tree, const Model& model, const mjModel& theirs)
    : model_(model), theirs_(theirs) {
  for (const std::string& name : joints_of(tree, theirs)) {
    const auto found = std::find_if(model.joints.begin(), model.joints.end(),
                                    [&](const Joint& joint) { return joint.name == name; });
    ours_.push_back(found == model.joints.end() ? -1
                                                : static_cast<int>(found - model.joints.begin()));
  }
}

/// Sets a joint that an equality holds alone to the position of the equality, y0 + a0.
void JointMap::place_locked_joints(mjData& data) const {
  for (int e = 0; e < theirs_.neq; ++e) {
    const int joint = theirs_.eq_obj1id[e];
    if (theirs_.eq_type[e] != mjEQ_JOINT || theirs_.eq_obj2id[e] >= 0) continue;
    if (ours_[static_cast<std::size_t>(joint)] >= 0) continue;
    data.qpos[theirs_.jnt_qposadr[joint]] += theirs_.eq_data[mjNEQDATA * e];
  }
}

void JointMap::store(const Eigen::VectorXd& q, const Eigen::VectorXd& v, mjData& data,
                     Eigen::MatrixXd& B, Eigen::VectorXd& drift) const {
  B.setZero(theirs_.nv, model_.nv);
  drift.setZero(theirs_.nv);
  mju_copy(data.qpos, theirs_.qpos0, theirs_.nq);
  place_locked_joints(data);
  for (int j = 0; j < theirs_.njnt; ++j) {
    const int index = ours_[static_cast<std::size_t>(j)];
    if (index < 0) continue;
    const Joint& joint = model_.joints[static_cast<std::size_t>(index)];
    mjtNum* qpos = data.qpos + theirs_.jnt_qposadr[j];
    const int dof = theirs_.jnt_dofadr[j];
    if (theirs_.jnt_type[j] == mjJNT_FREE) {
      const auto x = q.segment<7>(joint.q_index);
      const Eigen::Quaterniond r(x[6], x[3], x[4], x[5]);
      const double theirs_q[7] = {x[0], x[1], x[2], x[6], x[3], x[4], x[5]};
      mju_copy(qpos, theirs_q, 7);
      B.block<3, 3>(dof, joint.v_index) = r.toRotationMatrix();
      B.block<3, 3>(dof + 3, joint.v_index + 3).setIdentity();
      const Eigen::Vector3d u = v.segment<3>(joint.v_index), w = v.segment<3>(joint.v_index + 3);
      drift.segment<3>(dof) = r * w.cross(u);
    } else if (theirs_.jnt_type[j] == mjJNT_BALL) {
      const auto x = q.segment<4>(joint.q_index);
      const double theirs_q[4] = {x[3], x[0], x[1], x[2]};
      mju_copy(qpos, theirs_q, 4);
      B.block<3, 3>(dof, joint.v_index).setIdentity();
    } else {
      const double factor = joint.follows ? joint.follows->multiplier : 1.0;
      const double offset = joint.follows ? joint.follows->offset : 0.0;
      qpos[0] = factor * q[joint.q_index] + offset;
      B(dof, joint.v_index) = factor;
    }
  }
  Eigen::Map<Eigen::VectorXd>(data.qvel, theirs_.nv) = B * v;
}

}  // namespace burnish::testing
