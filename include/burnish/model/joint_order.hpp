// Vectors over joints as another program orders and writes them.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// How vectors of another program write the joints.
/// @described model
enum class JointConvention {
  Angles,  ///< one angle of a continuous joint; else as in q, v and tau here
  Same,    ///< as in q, v and tau here, (cos, sin) of a continuous joint included
  /// one angle of a continuous joint; quaternions w x y z; the linear velocity of a floating joint
  /// along the axes of its parent
  Mujoco,
};

/// Largest distance of a follower or a held joint from where the model has it that q_from() accepts
/// [rad or m]. Simulators hold such joints by soft constraints.
inline constexpr double coupling_tolerance = 0.01;

/// Maps vectors between a list of joint names and a model: q, v and tau of another program to those
/// of the model, and back. Followers and held joints may be in the list; the model has no entries
/// for them.
class JointOrder {
 public:
  /// Order of `names`. Throws Error with the nearest known name for a joint that the model does not
  /// have, and for a name that is empty or listed twice.
  JointOrder(Model model, std::vector<std::string> names,
             JointConvention convention = JointConvention::Angles);

  /// Order and values of MuJoCo's qpos, qvel and qfrc for a model that was read from MJCF.
  static JointOrder mujoco(const Model& model);

  const std::vector<std::string>& names() const { return names_; }
  int nq() const { return nq_; }  ///< entries of a vector of positions
  int nv() const { return nv_; }  ///< entries of a vector of velocities or torques

  /// q of the model (nq). Throws Error for a wrong size, a number that is not finite, a quaternion
  /// or pair without unit length (to 1e-3), a joint of the model that the names leave out, and a
  /// follower or held joint that is further than `tolerance` from where the model has it.
  Eigen::VectorXd q_from(const Eigen::Ref<const Eigen::VectorXd>& positions,
                         double tolerance = coupling_tolerance) const;
  /// Positions in this order; of followers and held joints where the model has them. Throws Error
  /// for a q that is no configuration.
  Eigen::VectorXd q_to(const Eigen::Ref<const Eigen::VectorXd>& q) const;

  /// v of the model (nv) at its configuration q. Velocities of followers and held joints are passed
  /// over. Throws Error for a wrong size, a number that is not finite, and a joint left out.
  Eigen::VectorXd v_from(const Eigen::Ref<const Eigen::VectorXd>& velocities,
                         const Eigen::Ref<const Eigen::VectorXd>& q) const;
  /// Velocities in this order: of held joints zero, of followers as their leaders move them.
  Eigen::VectorXd v_to(const Eigen::Ref<const Eigen::VectorXd>& v,
                       const Eigen::Ref<const Eigen::VectorXd>& q) const;

  /// tau of the model (nv) at its configuration q: zero for joints that the names leave out. The
  /// torque of a follower, times its multiplier, is added to its leader's; what holds held joints
  /// is passed over. Throws Error for a wrong size and a number that is not finite.
  Eigen::VectorXd tau_from(const Eigen::Ref<const Eigen::VectorXd>& torques,
                           const Eigen::Ref<const Eigen::VectorXd>& q) const;
  /// Torques in this order: of followers and held joints zero.
  Eigen::VectorXd tau_to(const Eigen::Ref<const Eigen::VectorXd>& tau,
                         const Eigen::Ref<const Eigen::VectorXd>& q) const;

 private:
  /// A name of the list: where its entries begin there, and the joint that it is.
  struct Place {
    StatedJoint stated;
    int q = 0, v = 0;
  };

  void add(const StatedJoint& stated);
  const Joint* moving(const Place& place) const;  ///< nullptr: held
  bool is_continuous(int joint) const;
  void require_all_joints() const;
  void check(const Eigen::Ref<const Eigen::VectorXd>& entries, int size, const char* what) const;
  Eigen::VectorXd stated_position(const Place& place,
                                  const Eigen::Ref<const Eigen::VectorXd>& q) const;
  /// Axes of the linear velocity of a floating or planar joint in its own axes.
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
