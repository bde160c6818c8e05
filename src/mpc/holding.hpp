// What an MpcController sends after a fault: see Fallback.
#pragma once

#include <Eigen/Cholesky>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc.hpp"
#include "dynamics/tree.hpp"
#include "mpc/sole_limits.hpp"

namespace burnish {

class Holding {
 public:
  Holding(const MpcSpec& spec, std::vector<int> actuated);

  void reset() noexcept;
  /// What the robot carries at a frame: as ContactDynamics::set_payload. `loaded`: the frame's body
  /// with it, of status Ok.
  void set_payload(std::string_view frame, const InertiaSpec& payload, const LoadedBody& loaded);
  /// The motor of an entry of v gives nothing from now on, until reset(); -1: all do.
  void do_without(int entry) noexcept { lost_ = entry; }
  /// The next time it holds, it holds where the robot is then.
  void release() noexcept { holding_ = false; }
  /// tau (nv, Nm or N) at q, v; zero where the dynamics cannot be evaluated. fresh: q and v are of
  /// this tick. wrenches: Measurement::support_wrenches, of as many columns as
  /// MpcSpec::support_sensors says.
  void torque(const Eigen::VectorXd& q, const Eigen::VectorXd& v, bool fresh,
              const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches,
              Eigen::VectorXd& tau) noexcept;
  /// Torques of the actuated entries (nv, zero elsewhere; Nm, N) that hold the robot still: b(q,
  /// 0), with what the other joints of a robot with loops, or on supports, lay on them. Null where
  /// they cannot be evaluated.
  const Eigen::VectorXd* at_rest(const Eigen::VectorXd& q) noexcept;
  /// What ankles may do, which holds for plans too.
  const SoleLimits& soles() const noexcept { return soles_; }

 private:
  bool stretch(const Eigen::VectorXd& q, bool fresh) noexcept;
  bool weigh_freely(const Eigen::VectorXd& q) noexcept;
  void leave_out_lost() noexcept;
  void weigh_by_loads(const Eigen::VectorXd& q,
                      const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches) noexcept;
  bool weigh_what_is_carried(const Eigen::VectorXd& q) noexcept;

  Fallback fallback_;
  double tick_period_, bridged_;  ///< s
  std::vector<int> actuated_;
  Eigen::VectorXd effort_;
  Tree tree_;
  bool is_closed_;
  int lost_ = -1;         ///< entry of v
  ContactDynamics free_;  ///< the robot without contacts but its supports and loops
  /// Of a robot on feet with sensors: what hangs where they bear nothing.
  struct Foot {
    Eigen::Index sensor;        ///< column of the wrenches
    std::vector<char> carries;  ///< nv: whether the entry is between it and the base
  };
  std::vector<Foot> feet_;
  SoleLimits soles_;
  ContactDynamics open_;    ///< the robot in the air
  Eigen::VectorXd share_;   ///< nv, of what stands: 1, of what hangs: 0
  double gravity_;          ///< m/s^2
  double weight_per_foot_;  ///< N, with what is carried
  /// At the last at_rest(): torques that hold, and what moves the actuated entries (nv x nv).
  Eigen::VectorXd weight_;
  Eigen::MatrixXd mass_;
  Eigen::MatrixXd mobility_, square_,
      inertia_;  ///< of the actuated entries alone, of a robot that is closed
  Eigen::VectorXd fall_, scale_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd zero_, q_hold_, error_, stretch_, pull_;  ///< nv, nq, nv, nv, nv
  double blind_for_ = 0.0;                                  ///< s without a good measurement
  bool holding_ = false;                                    ///< the spring has its q_hold_
};

}  // namespace burnish
