// Monitor of the task during control. It detects feet that slip, and a trunk that sinks or tips.
#pragma once

#include "burnish/tasks/stand/stand.hpp"

namespace burnish::stand {

/// Phases of the schedule, in the order of phase_names().
enum Phase : int { settle, sway, rest };

/// Returns how far a foot has slid along the ground from its start, without its rolling [m].
double slip_of(const Eigen::Isometry3d& start, const Eigen::Isometry3d& now,
               const Standing& standing);
/// Returns the angle between two orientations [rad].
double turn_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

/// Deviation of the trunk from its target; a large deviation means a fall.
struct TrunkFall {
  double sunk;    ///< Loss of height of the centre of mass, as a fraction of its height.
  double turned;  ///< Angle of the base from its target [rad].
};
TrunkFall lying_at(const Setting& setting, const Trunk& wanted, const Eigen::Vector3d& com,
                   const Eigen::Matrix3d& R_base);

class Swaying final : public MpcTask {
 public:
  Swaying(const MpcSpec& spec, Task task, Setting setting);

  std::vector<WatchedQuantity> watched() const override;
  void watch(const TaskView& view, std::span<Reading> out) noexcept override;
  void aim(double time, Command& command) override;

 private:
  Task task_;
  Setting setting_;
  int base_;               ///< Frame index of the base, for RigidBody.
  std::vector<int> feet_;  ///< Frame indices of the feet, for RigidBody.
  std::vector<Eigen::Isometry3d> start_;
};

}  // namespace burnish::stand
