// What the task watches while it is controlled: contact of both hands, and when the search for the
// largest force is over.
#pragma once

#include <array>

#include "burnish/tasks/push_wall/push_wall.hpp"
#include "pressing/bearing.hpp"
#include "pressing/sliding.hpp"

namespace burnish::push_wall {

/// Of the schedule, as phase_names() counts them.
enum Phase : int { settle, approach, ramp, hold, lean, top, release, retreat };

/// s in which the force comes down from the largest one to the share that is held.
inline constexpr double back_duration = 1.5;

/// What the robot may bear at rest within the limits that plans keep: how hard each hand can push.
pressing::Bearing make_bearing(const Task& task, const Setting& setting);

/// Its events are "contact", both hands above the threshold, and "limit", see Limit.
class Pushing final : public MpcTask {
 public:
  Pushing(const MpcSpec& spec, const Task& task, const Setting& setting,
          std::shared_ptr<LeanState> lean);

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
    double quick = 0.0, touch = 0.0;  ///< N along the normal, means over 5 and 10 ms
    double without = 0.0;             ///< s without force
    double felt = 0.0;                ///< N, largest `touch` since contact was due, or was lost
    Eigen::Isometry3d contact = Eigen::Isometry3d::Identity();  ///< where it was made, world
    Eigen::Vector3d crept = Eigen::Vector3d::Zero();            ///< m, slid() of about a second ago
  };
  void feel(const TaskView& view) noexcept;
  void creep(const RigidBody& body) noexcept;
  bool slides(const TaskView& view, int& hand, int& foot) noexcept;
  double slip_of(const Hand& hand, const RigidBody& body) const noexcept;
  Limit look(const TaskView& view, int& where) noexcept;
  bool bears(const TaskView& view, double force) noexcept;

  Task task_;
  Setting setting_;
  std::shared_ptr<LeanState> lean_;
  std::array<Hand, 2> hands_;
  std::vector<int> feet_;                          ///< frames
  std::vector<Eigen::Vector3d> p_feet_, p_crept_;  ///< m, world: at first, and a second ago
  double least_ = 0.0;                             ///< m, height of the centre of mass at the start
  double behind_ = 0.0;                            ///< N, mean over 0.1 s
  double infeasible_ = 0.0;                        ///< s that plans could not keep their limits
  double late_ = 0.0;                              ///< s that contact is late
  pressing::Bearing bearing_;
  double asked_ = 0.0;  ///< s since the posture was asked what it bears
  double short_ = 0.0;  ///< s that it could not bear enough
};

}  // namespace burnish::push_wall
