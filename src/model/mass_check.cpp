// Check of the mass matrix by articulated inertias at one generic posture. I_i is the inertia of
// body i alone, S_i are the directions of its joint, and X transforms motions from a body to its
// child c. The articulated inertia of body i, with all joints beyond it free to move, is
//   A_i = I_i + sum over children c of X^T (A_c - A_c S_c D_c^-1 S_c^T A_c) X,
//   D_c = S_c^T A_c S_c + armature.
// The mass matrix is positive definite if and only if every D_c is. A quantity that is zero at a
// generic posture, without special angles, is zero at all postures.
#include "model/mass_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "model/posture.hpp"

namespace burnish {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using JointAxes = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

constexpr double no_inertia = 1e-12;  // inertia that counts as zero, chosen by hand [kg m^2, kg]

Eigen::Matrix3d skew(const Eigen::Vector3d& x) {
  Eigen::Matrix3d result;
  result << 0.0, -x.z(), x.y(), x.z(), 0.0, -x.x(), -x.y(), x.x(), 0.0;
  return result;
}

/// Returns the inertia of a body about its frame's origin, linear rows first.
Matrix6d spatial_inertia(const Joint& joint) {
  const Eigen::Matrix3d cross = skew(joint.com);
  Matrix6d result;
  result << joint.mass * Eigen::Matrix3d::Identity(), -joint.mass * cross, joint.mass * cross,
      joint.inertia_at_com - joint.mass * cross * cross;
  return result;
}

/// Returns the transform of motions from the parent's frame to a frame at `placement` in it.
Matrix6d motion_transform(const Eigen::Isometry3d& placement) {
  const Eigen::Matrix3d back = placement.linear().transpose();
  Matrix6d result;
  result << back, -back * skew(placement.translation()), Eigen::Matrix3d::Zero(), back;
  return result;
}

JointAxes directions_of(JointKind kind) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Continuous:
      return Matrix6d::Identity().col(5);
    case JointKind::Prismatic:
      return Matrix6d::Identity().col(2);
    case JointKind::Planar: {
      JointAxes planar = JointAxes::Zero(6, 3);
      planar(0, 0) = planar(1, 1) = planar(5, 2) = 1.0;
      return planar;
    }
    case JointKind::Ball:
      return Matrix6d::Identity().rightCols<3>();
    case JointKind::FreeFlyer:
      break;
  }
  return Matrix6d::Identity();
}

/// Returns the body's placement in the parent body, at a joint position that depends on the index
/// of the joint.
Eigen::Isometry3d generic_placement(const Joint& joint, std::size_t index) {
  const double value = 0.3 + std::fmod(0.618 * static_cast<double>(index), 1.0);
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  if (joint.kind == JointKind::Prismatic) {
    moved.translation().z() = value;
  } else if (joint.kind == JointKind::Ball) {
    const Eigen::Vector3d axis = Eigen::Vector3d(0.48, 0.6, 0.64);
    moved.linear() = Eigen::AngleAxisd(value, axis).toRotationMatrix();
  } else if (joint.kind != JointKind::FreeFlyer) {
    moved.linear() = Eigen::AngleAxisd(value, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  return joint.placement * moved;
}

/// Inertia along the directions of a joint.
struct JointInertia {
  Square inertia;             ///< S^T A S + armature, if all joints beyond can move
  Square carried;             ///< Inertia if all joints beyond are locked
  SymmetricEigen decomposed;  ///< Eigenvalues and eigenvectors of `inertia`

  JointInertia(Square articulated, Square rigid)
      : inertia(std::move(articulated)),
        carried(std::move(rigid)),
        decomposed(symmetric_eigen(inertia)) {}
  double smallest() const { return decomposed.values[0]; }
  /// Returns the threshold below which an eigenvalue counts as zero. Rounding errors of the
  /// articulated inertia grow with the carried inertia.
  double tolerance() const {
    return no_inertia * std::max(1.0, carried.diagonal().cwiseAbs().maxCoeff());
  }
  /// Returns the pseudo-inverse of `inertia`: directions without inertia map to zero.
  Square inverse() const {
    const auto along = decomposed.values.array();
    const Eigen::ArrayXd inverses = (along.abs() > tolerance()).select(1.0 / along, 0.0);
    return decomposed.vectors * inverses.matrix().asDiagonal() * decomposed.vectors.transpose();
  }
};

/// Names of joints.
using Names = std::vector<std::string>;

/// Joints with a singular or negative inertia.
struct Oddities {
  Names massless, twins, negative;

  void examine(const Joint& joint, const JointInertia& along) {
    if (along.smallest() > along.tolerance()) return;
    const double carried = symmetric_eigen(along.carried).values[0];
    if (along.smallest() < -along.tolerance()) {
      negative.push_back(joint.name);
    } else if (carried <= no_inertia) {
      massless.push_back(joint.name);
    } else {
      twins.push_back(joint.name);
    }
  }
  void warn(Findings& findings) const {
    const auto add = [&](const Names& names, const std::string& what) {
      if (!names.empty()) findings.warn(listed("joint", names) + what);
    };
    const auto verb = [](const Names& names, const char* one, const char* several) {
      return std::string(names.size() == 1 ? one : several);
    };
    add(massless,
        verb(massless, " moves", " move") +
            " no mass, so that the mass matrix is singular; give a link beyond the joint a mass, "
            "or the joint an armature, or lock the joint");
    add(twins,
        verb(twins, " moves", " move") +
            " no mass of its own, so that the mass matrix is singular: joints beyond it move "
            "the same bodies in the same directions; give its link a mass or lock the joint");
    add(negative, verb(negative, " moves", " move") +
                      " a negative inertia, so that the mass matrix is not positive definite; "
                      "correct the inertias of the links beyond the joint or lock the joint");
  }
};

/// Returns, for each joint, the sum of its followers' inertias times multiplier^2, with all joints
/// beyond the followers rigid. `subtree` holds the inertias of the bodies.
std::vector<double> inertia_of_followers(const Model& model, std::vector<Matrix6d> subtree) {
  std::vector<double> result(model.joints.size(), 0.0);
  for (std::size_t i = model.joints.size(); i-- > 0;) {
    const Joint& joint = model.joints[i];
    if (joint.follows) {
      const JointAxes along = directions_of(joint.kind);
      const double factor = joint.follows->multiplier;
      result[to_size(joint.follows->leader)] +=
          factor * factor * (along.transpose() * subtree[i] * along)(0, 0);
    }
    if (joint.parent < 0) continue;
    const Matrix6d to_body = motion_transform(generic_placement(joint, i));
    subtree[to_size(joint.parent)] += to_body.transpose() * subtree[i] * to_body;
  }
  return result;
}

}  // namespace

void check_inertia_along_joints(const Model& model, Findings& findings) {
  std::vector<Matrix6d> articulated, composite;
  for (const Joint& joint : model.joints) {
    articulated.push_back(spatial_inertia(joint));
    composite.push_back(articulated.back());
  }
  const std::vector<double> followers = inertia_of_followers(model, composite);
  Oddities oddities;
  for (std::size_t i = model.joints.size(); i-- > 0;) {
    const Joint& joint = model.joints[i];
    Matrix6d transmitted = articulated[i];  // inertia that the parent feels
    bool finite = articulated[i].allFinite() && composite[i].allFinite();
    if (!joint.follows) {  // a follower does not move by itself
      const JointAxes along = directions_of(joint.kind);
      Square added = model.armature.segment(joint.v_index, joint.nv).asDiagonal();
      added(0, 0) += followers[i];
      const JointInertia joint_inertia(along.transpose() * articulated[i] * along + added,
                                       along.transpose() * composite[i] * along + added);
      finite = finite && joint_inertia.inertia.allFinite();
      if (finite) oddities.examine(joint, joint_inertia);
      const JointAxes forces = articulated[i] * along;
      transmitted -= forces * joint_inertia.inverse() * forces.transpose();
    }
    if (!finite) {
      findings.problem("joint " + in_quotes(joint.name) +
                       ": the inertia that it moves overflows; wanted finite inertias");
      return;
    }
    if (joint.parent < 0) continue;
    const auto parent = to_size(joint.parent);
    const Matrix6d to_body = motion_transform(generic_placement(joint, i));
    articulated[parent] += to_body.transpose() * transmitted * to_body;
    composite[parent] += to_body.transpose() * composite[i] * to_body;
  }
  oddities.warn(findings);
}

std::string simulation_problem(const Model& model) {
  if (model.joints.empty()) return "";
  std::vector<std::string> names;
  for (const Joint& joint : model.joints) names.push_back(joint.name);
  if (model.total_mass() <= 0.0)
    return listed("joint", names) + (names.size() == 1 ? " moves" : " move") +
           " no mass, so that the robot cannot be simulated; give the links that move a mass";
  Findings findings("");
  check_inertia_along_joints(model, findings);
  std::string text;
  for (const std::string& warning : findings.warnings())
    text += (text.empty() ? "" : "; ") + warning.substr(std::string_view(": ").size());
  return text;
}

void require_simulable(const Model& model) {
  const std::string problem = simulation_problem(model);
  if (!problem.empty()) refuse("robot " + in_quotes(model.name), problem);
}

}  // namespace burnish
