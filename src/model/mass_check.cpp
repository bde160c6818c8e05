// Articulated inertias at one generic posture. With S_i the joint's directions and A_i the inertia
// that body i shows when all joints beyond it are free to give way,
//   A_i = I_i + sum over children of X^T (A_c - A_c S_c D_c^-1 S_c^T A_c) X,  D_c = S_c^T A_c S_c +
//   armature,
// and the mass matrix is positive definite exactly when every D is. A posture at which no angle is
// special stands for all: what is zero there is zero everywhere.
#include "model/mass_check.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "model/posture.hpp"
#include "model/sentence.hpp"

namespace burnish {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Directions = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

constexpr double no_inertia = 1e-12;  // kg m^2 or kg

Eigen::Matrix3d skew(const Eigen::Vector3d& x) {
  Eigen::Matrix3d result;
  result << 0.0, -x.z(), x.y(), x.z(), 0.0, -x.x(), -x.y(), x.x(), 0.0;
  return result;
}

/// Inertia of a body about its frame's origin, linear first.
Matrix6d spatial_inertia(const Joint& joint) {
  const Eigen::Matrix3d cross = skew(joint.com);
  Matrix6d result;
  result << joint.mass * Eigen::Matrix3d::Identity(), -joint.mass * cross, joint.mass * cross,
      joint.inertia_at_com - joint.mass * cross * cross;
  return result;
}

/// Takes motions in the parent's frame to the frame placed in it.
Matrix6d motion_transform(const Eigen::Isometry3d& placement) {
  const Eigen::Matrix3d back = placement.linear().transpose();
  Matrix6d result;
  result << back, -back * skew(placement.translation()), Eigen::Matrix3d::Zero(), back;
  return result;
}

Directions directions_of(JointKind kind) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Continuous:
      return Matrix6d::Identity().col(5);
    case JointKind::Prismatic:
      return Matrix6d::Identity().col(2);
    case JointKind::Planar: {
      Directions planar = Directions::Zero(6, 3);
      planar(0, 0) = planar(1, 1) = planar(5, 2) = 1.0;
      return planar;
    }
    case JointKind::FreeFlyer:
      break;
  }
  return Matrix6d::Identity();
}

/// The body's placement in the parent body at a posture that differs from joint to joint.
Eigen::Isometry3d generic_placement(const Joint& joint, std::size_t index) {
  const double value = 0.3 + std::fmod(0.618 * static_cast<double>(index), 1.0);
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  if (joint.kind == JointKind::Prismatic) {
    moved.translation().z() = value;
  } else if (joint.kind != JointKind::FreeFlyer) {
    moved.linear() = Eigen::AngleAxisd(value, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  return joint.placement * moved;
}

double smallest_eigenvalue(const Square& matrix) {
  return Eigen::SelfAdjointEigenSolver<Square>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

void require_inertia(const Joint& joint, const Square& met, const Square& carried,
                     const std::string& origin) {
  // Rounding of the subtraction grows with what was subtracted from.
  const double tolerance = no_inertia * std::max(1.0, carried.diagonal().maxCoeff());
  if (smallest_eigenvalue(met) > tolerance) return;
  if (smallest_eigenvalue(carried) <= no_inertia) {
    refuse(origin, "joint " + in_quotes(joint.name) +
                       " moves no mass: all that it carries has no inertia along it, and its "
                       "armature is 0; give its link a mass or lock it");
  }
  refuse(origin, "joint " + in_quotes(joint.name) +
                     " moves no mass of its own: joints beyond it move the same bodies in the same "
                     "way; give its link a mass or lock it");
}

}  // namespace

void check_inertia_along_joints(const Model& model, const std::string& origin) {
  std::vector<Matrix6d> articulated, composite;
  for (const Joint& joint : model.joints) {
    articulated.push_back(spatial_inertia(joint));
    composite.push_back(articulated.back());
  }
  for (std::size_t i = model.joints.size(); i-- > 0;) {
    const Joint& joint = model.joints[i];
    const Directions along = directions_of(joint.kind);
    const Square armature = model.armature.segment(joint.v_index, joint.nv).asDiagonal();
    const Square met = along.transpose() * articulated[i] * along + armature;
    require_inertia(joint, met, along.transpose() * composite[i] * along + armature, origin);
    if (joint.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(joint.parent);
    const Matrix6d to_body = motion_transform(generic_placement(joint, i));
    const Directions pushed = articulated[i] * along;
    const Matrix6d given = articulated[i] - pushed * met.ldlt().solve(pushed.transpose());
    articulated[parent] += to_body.transpose() * given * to_body;
    composite[parent] += to_body.transpose() * composite[i] * to_body;
  }
}

}  // namespace burnish
