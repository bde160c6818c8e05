// The force of a stage's contacts by forward dynamics, at torques that are known.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc.hpp"

namespace burnish {

class ContactForceEstimate {
 public:
  explicit ContactForceEstimate(const MpcSpec& spec);
  /// MpcTask::surface.
  void set_surface(const Quadric& surface) noexcept;
  /// The coefficient of the tool's contacts with friction.
  void set_friction(double coefficient) noexcept;
  /// ContactDynamics::set_payload.
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)dynamics_.set_payload(frame, payload);
  }
  bool has_contact(int stage) const noexcept;
  /// Forward dynamics at tau (nv) with the contacts of a stage, or only with those that carry the
  /// robot. False where there is no solution.
  bool forward(int stage, double time, bool with_all, const ConstVectorRef& q,
               const ConstVectorRef& v, const Eigen::VectorXd& tau) noexcept;
  auto acceleration() const { return dynamics_.a(); }  ///< nv, of forward()
  /// Of all contacts of the stage, N, world axes, at tau (nv), their references as they are at a
  /// time of the schedule, s. False and zero where it has none, or the dynamics no solution.
  bool force_at(int stage, double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                const Eigen::VectorXd& tau, Eigen::Vector3d& out) noexcept;

 private:
  bool turn(double time) noexcept;

  std::vector<Signal> rotations_;  ///< per contact, empty where its reference stays
  Eigen::VectorXd xyzw_;
  ContactDynamics dynamics_;
  std::vector<int> following_;  ///< contacts_on_surface()
  std::vector<int> rubbing_;    ///< contacts_that_rub()
  std::vector<char> carries_;   ///< per contact: of the robot's own, which is no force on it
  std::vector<std::vector<char>> holds_;  ///< per stage and contact: the stage has it
};

}  // namespace burnish
