// What an MpcController sends after a fault: see Fallback.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc.hpp"
#include "dynamics/tree.hpp"

namespace burnish {

class Holding {
 public:
  Holding(const MpcSpec& spec, std::vector<int> actuated);

  void reset() noexcept;
  /// What the robot carries at a frame: as ContactDynamics::set_payload, whose status it is.
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)free_.set_payload(frame, payload);
  }
  /// The next time it holds, it holds where the robot is then.
  void release() noexcept { holding_ = false; }
  /// tau (nv, Nm or N) at q, v; zero where the dynamics cannot be evaluated. fresh: q and v are of
  /// this tick.
  void torque(const Eigen::VectorXd& q, const Eigen::VectorXd& v, bool fresh,
              Eigen::VectorXd& tau) noexcept;
  /// b(q, 0), nv, Nm (N), that holds the robot still; null where it cannot be evaluated.
  const ContactDynamics* at_rest(const Eigen::VectorXd& q) noexcept;

 private:
  bool stretch(const Eigen::VectorXd& q, bool fresh) noexcept;

  Fallback fallback_;
  double tick_period_, bridged_;  ///< s
  std::vector<int> actuated_;
  Eigen::VectorXd effort_;
  Tree tree_;
  ContactDynamics free_;                                    ///< the robot without contacts
  Eigen::VectorXd zero_, q_hold_, error_, stretch_, pull_;  ///< nv, nq, nv, nv, nv
  double blind_for_ = 0.0;                                  ///< s without a good measurement
  bool holding_ = false;                                    ///< the spring has its q_hold_
};

}  // namespace burnish
