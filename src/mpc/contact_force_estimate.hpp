// Estimate of contact forces in a stage of the schedule, by forward dynamics with given torques.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc.hpp"

namespace burnish {

class ContactForceEstimate {
 public:
  explicit ContactForceEstimate(const MpcSpec& spec);
  /// Sets the surface (MpcTask::surface) in the references of all contacts that follow it.
  void set_surface(const Quadric& surface) noexcept;
  /// Sets the coefficient of friction of all tool contacts that have friction.
  void set_friction(double coefficient) noexcept;
  /// Sets the payload at a frame, see ContactDynamics::set_payload().
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)dynamics_.set_payload(frame, payload);
  }
  /// Returns true if the stage has a contact other than supports and loops.
  bool has_contact(int stage) const noexcept;
  /// Computes the forward dynamics with the torques `tau` (nv) [Nm or N]. `time`: time of the
  /// schedule [s]. `with_all`: true for all contacts of the stage, false for its supports and loops
  /// alone. Returns false if there is no solution.
  bool forward(int stage, double time, bool with_all, const ConstVectorRef& q,
               const ConstVectorRef& v, const Eigen::VectorXd& tau) noexcept;
  auto acceleration() const { return dynamics_.a(); }  ///< Acceleration of the last forward(), nv.
  /// Sets `out` to the sum of the contact forces on the robot in a stage, in world axes [N]. Forces
  /// of supports and loops are not included. `tau`: torques (nv) [Nm or N]. `time`: time of the
  /// schedule at which references are evaluated [s]. Returns false and a zero force if the stage
  /// has no other contact, or if the dynamics have no solution.
  bool force_at(int stage, double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                const Eigen::VectorXd& tau, Eigen::Vector3d& out) noexcept;

 private:
  /// Sets the rotations of the contacts' references to their values at `time` [s]. Returns false if
  /// a rotation cannot be evaluated.
  bool set_rotations(double time) noexcept;

  /// Rotation of each contact's reference over time; empty if the rotation is constant.
  std::vector<Signal> rotations_;
  Eigen::VectorXd xyzw_;
  ContactDynamics dynamics_;
  std::vector<int> following_;      ///< Indices by contacts_on_surface().
  std::vector<int> with_friction_;  ///< Indices by contacts_with_friction().
  /// Per contact: 1 for supports and loops, whose forces force_at() leaves out.
  std::vector<char> carries_;
  /// Per stage and contact: 1 if the contact is active in the stage.
  std::vector<std::vector<char>> holds_;
};

}  // namespace burnish
