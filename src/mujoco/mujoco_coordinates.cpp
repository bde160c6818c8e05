#include "mujoco/mujoco_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "model/followers.hpp"
#include "model/joint_entries.hpp"
#include "sim/small_product.hpp"

namespace burnish::mujoco {
namespace {

using Vector3 = Eigen::Vector3d;

/// Returns the number of entries of qpos for a joint.
int count(JointKind kind) {
  switch (kind) {
    case JointKind::Planar:
      return 3;
    case JointKind::FreeFlyer:
      return 7;
    case JointKind::Ball:
      return 4;
    default:
      return 1;
  }
}

Eigen::Matrix3d about_z(double angle) {
  return Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
}

/// Writes a joint's coordinates. Returns the rotation from the joint's moving axes to its fixed
/// axes.
Eigen::Matrix3d store_joint(JointKind kind, const double* x, mjtNum* qpos) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      qpos[0] = x[0];
      break;
    case JointKind::Continuous:
      qpos[0] = std::atan2(x[1], x[0]);
      break;
    case JointKind::Planar:
      qpos[0] = x[0], qpos[1] = x[1], qpos[2] = std::atan2(x[3], x[2]);
      return about_z(qpos[2]);
    case JointKind::FreeFlyer:
      std::copy(x, x + 3, qpos);
      qpos[3] = x[6], qpos[4] = x[3], qpos[5] = x[4], qpos[6] = x[5];
      return Eigen::Quaterniond(x[6], x[3], x[4], x[5]).toRotationMatrix();
    case JointKind::Ball:
      qpos[0] = x[3], qpos[1] = x[0], qpos[2] = x[1], qpos[3] = x[2];
      break;
  }
  return Eigen::Matrix3d::Identity();
}

Eigen::Matrix3d load_joint(JointKind kind, const mjtNum* qpos, double* x) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      x[0] = qpos[0];
      break;
    case JointKind::Continuous:
      x[0] = std::cos(qpos[0]), x[1] = std::sin(qpos[0]);
      break;
    case JointKind::Planar:
      x[0] = qpos[0], x[1] = qpos[1], x[2] = std::cos(qpos[2]), x[3] = std::sin(qpos[2]);
      return about_z(qpos[2]);
    case JointKind::FreeFlyer:
      std::copy(qpos, qpos + 3, x);
      x[3] = qpos[4], x[4] = qpos[5], x[5] = qpos[6], x[6] = qpos[3];
      return Eigen::Quaterniond(x[6], x[3], x[4], x[5]).toRotationMatrix();
    case JointKind::Ball:
      x[0] = qpos[1], x[1] = qpos[2], x[2] = qpos[3], x[3] = qpos[0];
      break;
  }
  return Eigen::Matrix3d::Identity();
}

/// Returns the number of velocity entries whose axes differ in MuJoCo.
int turned_entries(const Joint& joint) { return joint.nv > 1 ? sliding_entries(joint.kind) : 0; }

}  // namespace

Coordinates::Coordinates(const Model& model, const mjModel& theirs)
    : model_(model),
      entry_(to_size(model.nv)),
      T_(Eigen::MatrixXd::Zero(model.nv, theirs.nv)),
      correction_(Eigen::VectorXd::Zero(model.nv)) {
  int first = 0;
  for (const Joint& joint : model.joints) {
    for (int k = 0; k < joint.nv; ++k) {
      entry_[to_size(joint.v_index + k)] = first + k;
      if (first + k < theirs.nv) T_(joint.v_index + k, first + k) = 1.0;
    }
    first += joint_nv(joint.kind);
  }
  if (theirs.nv != first)
    throw Error("MuJoCo's model has " + std::to_string(theirs.nv) + " degrees of freedom; wanted " +
                std::to_string(first));
  T_own_ = T_;
  first = 0;
  for (const Joint& joint : model.joints) {
    if (joint.follows) T_(joint.v_index, first) = joint.follows->multiplier;
    first += joint_nv(joint.kind);
  }
}

void Coordinates::turn(const Joint& joint, int first, const Eigen::Matrix3d& rotation) {
  const int n = turned_entries(joint);
  for (Eigen::MatrixXd* matrix : {&T_, &T_own_})
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) (*matrix)(joint.v_index + i, first + j) = rotation(j, i);
}

/// Computes the correction u x w for a joint whose axes turn, with its linear velocity u and
/// angular velocity w.
void Coordinates::correct(const Joint& joint, const ConstVectorRef& v) {
  if (turned_entries(joint) == 0) return;
  const bool planar = joint.kind == JointKind::Planar;
  const int first = joint.v_index;
  const Vector3 u(v[first], v[first + 1], planar ? 0.0 : v[first + 2]);
  const Vector3 w(planar ? 0.0 : v[first + 3], planar ? 0.0 : v[first + 4],
                  v[first + joint.nv - 1]);
  const Vector3 rate = u.cross(w);
  for (int i = 0; i < turned_entries(joint); ++i) correction_[first + i] = rate[i];
}

void Coordinates::store(const ConstVectorRef& q, const ConstVectorRef& v, mjData& data) {
  mjtNum* qpos = data.qpos;
  int first = 0;
  for (const Joint& joint : model_.joints) {
    if (joint.follows) {
      qpos[0] = joint_value(model_, joint, q);
    } else {
      turn(joint, first, store_joint(joint.kind, q.data() + joint.q_index, qpos));
      correct(joint, v);
    }
    qpos += count(joint.kind);
    first += joint_nv(joint.kind);
  }
  Eigen::Map<Eigen::VectorXd> qvel(data.qvel, T_.cols());
  multiply(T_.transpose(), v, qvel);
}

void Coordinates::load(const mjData& data, Eigen::VectorXd& q, Eigen::VectorXd& v) {
  const mjtNum* qpos = data.qpos;
  int first = 0;
  for (const Joint& joint : model_.joints) {
    if (!joint.follows) turn(joint, first, load_joint(joint.kind, qpos, q.data() + joint.q_index));
    qpos += count(joint.kind);
    first += joint_nv(joint.kind);
  }
  v.resize(T_.rows());
  multiply(T_own_, Eigen::Map<const Eigen::VectorXd>(data.qvel, T_.cols()), v);
}

void Coordinates::torque_to(const ConstVectorRef& tau, mjtNum* theirs) const {
  Eigen::Map<Eigen::VectorXd> mapped(theirs, T_.cols());
  multiply(T_own_.transpose(), tau, mapped);
}

void Coordinates::torque_from(const mjtNum* theirs, Eigen::VectorXd& tau) const {
  tau.resize(T_.rows());
  multiply(T_, Eigen::Map<const Eigen::VectorXd>(theirs, T_.cols()), tau);
}

Eigen::MatrixXd mass_matrix(const mjModel& model, const mjData& data, const Coordinates& at) {
  RowMatrix M(model.nv, model.nv);
  mj_fullM(&model, M.data(), data.qM);
  return at.T() * M * at.T().transpose();
}

Eigen::VectorXd bias(const mjModel& model, const mjData& data, const Coordinates& at) {
  const Eigen::VectorXd theirs = Eigen::Map<const Eigen::VectorXd>(data.qfrc_bias, model.nv);
  return at.T() * theirs - mass_matrix(model, data, at) * at.correction();
}

}  // namespace burnish::mujoco
