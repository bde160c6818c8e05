// Conversion of joint vectors (q, v, tau) between a model and another program.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Coordinates in which another program writes joint positions and velocities.
/// @described model
enum class JointConvention {
  /// As in q, v, tau of a Model, but with one angle for the rotation of a continuous or planar
  /// joint
  Angles,
  /// As in q, v, tau of a Model, with (cos, sin) for the rotation of a continuous or planar joint
  Same,
  /// As in MuJoCo: one angle for the rotation of a continuous or planar joint, quaternions w x y z,
  /// and the linear velocity of a floating or planar joint in the axes of its parent
  Mujoco,
};

/// Default tolerance of JointOrder::q_from() [rad or m]: largest deviation of a coupled or held
/// joint from its position in the model. Simulators couple and hold joints by soft constraints,
/// which permit small deviations.
inline constexpr double coupling_tolerance = 0.01;

/// Converts the vectors q, v and tau between a model and another program. A list of names states
/// the order of joints in the other program. The list may include held joints, and followers
/// (joints that are coupled to a leader). The model's vectors have no entries for followers and
/// held joints.
class JointOrder {
 public:
  /// Creates the conversion for joints in the order of `names`. Throws Error if a name is empty or
  /// listed twice, or with the nearest known name if the model has no such joint.
  JointOrder(Model model, std::vector<std::string> names,
             JointConvention convention = JointConvention::Angles);

  /// Returns the conversion to MuJoCo's qpos, qvel and qfrc, for a model that was read from MJCF.
  static JointOrder mujoco(const Model& model);

  const std::vector<std::string>& names() const { return names_; }
  int nq() const { return nq_; }  ///< Size of a position vector of the other program
  int nv() const { return nv_; }  ///< Size of a velocity or torque vector of the other program

  /// Converts positions of the other program (nq() entries) to q of the model. Throws Error if
  ///  - the size is wrong or a number is not finite;
  ///  - the length of a quaternion or (cos, sin) pair differs from 1 by more than 1e-3;
  ///  - names() lacks a moving joint of the model;
  ///  - a coupled joint (follower) or held joint deviates by more than `tolerance` from its
  ///    position in the model.
  Eigen::VectorXd q_from(const Eigen::Ref<const Eigen::VectorXd>& positions,
                         double tolerance = coupling_tolerance) const;
  /// Converts q of the model to positions of the other program (nq() entries). Coupled joints
  /// (followers) and held joints get their positions in the model. Throws Error if q is not a valid
  /// configuration.
  Eigen::VectorXd q_to(const Eigen::Ref<const Eigen::VectorXd>& q) const;

  /// Converts velocities of the other program (nv() entries) to v of the model. q is the model's
  /// configuration. Velocities of coupled joints (followers) and held joints are ignored. Throws
  /// Error for a wrong size, a number that is not finite, or a moving joint that names() lacks.
  Eigen::VectorXd v_from(const Eigen::Ref<const Eigen::VectorXd>& velocities,
                         const Eigen::Ref<const Eigen::VectorXd>& q) const;
  /// Converts v of the model to velocities of the other program (nv() entries). q is the model's
  /// configuration. Held joints get zero. A coupled joint (follower) gets the velocity of its
  /// leader times the multiplier of the coupling.
  Eigen::VectorXd v_to(const Eigen::Ref<const Eigen::VectorXd>& v,
                       const Eigen::Ref<const Eigen::VectorXd>& q) const;

  /// Converts torques of the other program (nv() entries) to tau of the model. q is the model's
  /// configuration. The torque of a coupled joint (follower) is multiplied by the multiplier of the
  /// coupling and added to the torque of its leader. Torques of held joints are ignored. Joints
  /// that names() lacks get zero. Throws Error for a wrong size or a number that is not finite.
  Eigen::VectorXd tau_from(const Eigen::Ref<const Eigen::VectorXd>& torques,
                           const Eigen::Ref<const Eigen::VectorXd>& q) const;
  /// Converts tau of the model to torques of the other program (nv() entries). q is the model's
  /// configuration. Coupled joints (followers) and held joints get zero.
  Eigen::VectorXd tau_to(const Eigen::Ref<const Eigen::VectorXd>& tau,
                         const Eigen::Ref<const Eigen::VectorXd>& q) const;

 private:
  /// A joint of the other program. q and v are the indices of its first position and its first
  /// velocity in the other program's vectors.
  struct Place {
    FileJoint stated;
    int q = 0, v = 0;
  };

  void add(const FileJoint& stated);
  const Joint* moving(const Place& place) const;  ///< nullptr if the joint is held
  bool is_continuous(int joint) const;
  void require_all_joints() const;
  void check(const Eigen::Ref<const Eigen::VectorXd>& entries, int size, const char* what) const;
  Eigen::VectorXd file_position(const Place& place,
                                const Eigen::Ref<const Eigen::VectorXd>& q) const;
  /// Returns the rotation matrix that maps the linear velocity of a floating or planar joint from
  /// joint axes to the axes of the other program.
  Eigen::Matrix3d linear_axes(const Place& place, const Eigen::Ref<const Eigen::VectorXd>& q) const;
  Eigen::VectorXd from(const Eigen::Ref<const Eigen::VectorXd>& entries,
                       const Eigen::Ref<const Eigen::VectorXd>& q, bool adds_followers) const;
  Eigen::VectorXd to(const Eigen::Ref<const Eigen::VectorXd>& entries,
                     const Eigen::Ref<const Eigen::VectorXd>& q, bool moves_followers) const;
  [[noreturn]] void refuse(const std::string& what) const;

  Model model_;
  JointConvention convention_;
  std::vector<std::string> names_;
  std::vector<Place> places_;
  int nq_ = 0, nv_ = 0;
};

}  // namespace burnish
