// Monitor of the task during control. It detects the contact of both hands, and the end of the
// search for the largest force.
#pragma once

#include <array>

#include "burnish/tasks/push_wall/push_wall.hpp"
#include "pressing/sliding.hpp"
#include "pressing/statics.hpp"

namespace burnish::push_wall {

/// Phases of the schedule, in the order of phase_names().
enum Phase : int { settle, approach, ramp, hold, force_search, top, release, retreat };

/// Duration of the ramp down after the search, from the largest force to the held fraction of it
/// [s]. Chosen by hand.
inline constexpr double back_duration = 1.5;

/// Returns the solver for the largest force with which each hand can push at rest. Its limits on
/// feet and torques equal those of the plans.
pressing::Statics make_statics(const Task& task, const Setting& setting);

/// Monitor with two events. "contact": the force of both hands exceeds the threshold. "limit": a
/// condition of Limit ends the search.
class Pushing final : public MpcTask {
 public:
  Pushing(const MpcSpec& spec, const Task& task, const Setting& setting,
          std::shared_ptr<SearchState> force_search);

  std::vector<std::string> events() const override { return {"contact", "limit"}; }
  std::vector<WatchedQuantity> watched() const override;
  void reset() noexcept override;
  unsigned sense(const TaskView& view) noexcept override;
  void watch(const TaskView& view, std::span<Reading> out) noexcept override;
  void explain(std::size_t quantity, std::span<char> clause) const noexcept override;
  void aim(double time, Command& command) override;

 private:
  struct Hand {
    int frame = -1;
    int column = -1;                  ///< Column of Measurement::wrenches.
    double quick = 0.0, touch = 0.0;  ///< Normal force, filtered over 5 and 10 ms [N].
    double without = 0.0;             ///< Time without contact force [s].
    double felt = 0.0;  ///< Largest `touch` since contact was due, or since it was lost [N].
    /// Placement of the hand at first contact.
    Eigen::Isometry3d contact = Eigen::Isometry3d::Identity();
    /// Slip as computed by slid(), low-pass filtered over 1 s [m].
    Eigen::Vector3d slow_slip = Eigen::Vector3d::Zero();
  };
  void filter_forces(const TaskView& view) noexcept;
  void reset_slow_slip(const RigidBody& body) noexcept;
  bool slides(const TaskView& view, int& hand, int& foot) noexcept;
  double slip_of(const Hand& hand, const RigidBody& body) const noexcept;
  Limit look(const TaskView& view, int& where) noexcept;
  bool has_static_reserve(const TaskView& view, double force) noexcept;

  Task task_;
  Setting setting_;
  std::shared_ptr<SearchState> search_;
  std::array<Hand, 2> hands_;
  std::vector<int> feet_;  ///< Frame indices of the feet, for RigidBody.
  /// Positions of the feet in the world: at the start, and low-pass filtered over 1 s [m].
  std::vector<Eigen::Vector3d> p_feet_, p_slow_;
  double start_height_ = 0.0;  ///< Height of the centre of mass at the start [m].
  double behind_ = 0.0;        ///< Force error, low-pass filtered over 0.1 s [N].
  double infeasible_ = 0.0;  ///< Time for which the constraints of plans have been infeasible [s].
  double late_ = 0.0;        ///< Time by which contact is late [s].
  pressing::Statics statics_;
  double unchecked_ = 0.0;  ///< Time since the last check of statics [s].
  double short_ = 0.0;      ///< Time for which the static reserve has been missing [s].
};

}  // namespace burnish::push_wall
