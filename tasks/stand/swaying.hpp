// What the task watches while it is controlled: feet that slip, and a trunk that sinks or tips.
#pragma once

#include "burnish/tasks/stand/stand.hpp"

namespace burnish::stand {

/// Of the schedule, as phase_names() counts them.
enum Phase : int { settle, sway, rest };

/// m: how far a foot is off where it was at the start, along the ground.
double slip_of(const Eigen::Isometry3d& start, const Eigen::Isometry3d& now,
               const Standing& standing);
/// rad.
double turn_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

/// Whether the trunk is so far off where it is to be that the robot lies.
struct Lying {
  double sunk;    ///< of the height of the centre of mass above the feet
  double turned;  ///< rad
};
Lying lying_at(const Setting& setting, const Trunk& wanted, const Eigen::Vector3d& com,
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
  int base_;               ///< frame
  std::vector<int> feet_;  ///< frames
  std::vector<Eigen::Isometry3d> start_;
};

}  // namespace burnish::stand
