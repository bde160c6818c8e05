// What is watched at a tool that presses, each part with its own state.
#pragma once

#include "burnish/tasks/pressing/pressing_task.hpp"
#include "pressing/contact_detector.hpp"

namespace burnish::pressing {

/// Ticks that a time is, one at least.
int samples_of(double time, double tick_period);

/// The mean of the measured force over a window.
class MeanForce {
 public:
  explicit MeanForce(int samples) : ring_(Eigen::Matrix3Xd::Zero(3, samples)) {}
  void reset() noexcept;
  void add(const Eigen::Vector3d& force) noexcept;
  const Eigen::Vector3d& value() const { return mean_; }  ///< N; of fewer until there are enough
  int samples() const { return static_cast<int>(ring_.cols()); }
  bool is_full() const { return count_ >= ring_.cols(); }

 private:
  Eigen::Matrix3Xd ring_;
  long count_ = 0;
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
};

/// Forces where none are wanted. What leaves begins pressed: it is free once the tool is off, and
/// stays off for longer than a bounce takes.
class FreeSpaceWatch {
 public:
  FreeSpaceWatch(const ToolLimits& limits, double contact_threshold)
      : limits_(limits), threshold_(contact_threshold) {}
  void reset() noexcept;
  /// pushed: N along the normal; the most that noise could be is `touch`'s.
  Reading look(Touch phase, double dt, double pushed, const MeanForce& mean,
               const ContactDetector& touch) noexcept;

 private:
  ToolLimits limits_;
  double threshold_;
  double leaves_for_ = 0.0, off_for_ = 0.0;  ///< s
  bool released_ = false;                    ///< the tool has come off, or should have
};

/// Contact that is due and does not come.
class ApproachWatch {
 public:
  explicit ApproachWatch(const ToolLimits& limits) : limits_(limits) {}
  void reset() noexcept { waits_for_ = due_height_ = travel_ = felt_ = 0.0; }
  /// height: m of the tool along the normal; force: N that is felt along it.
  void look(bool waits, double dt, double height, double force) noexcept;
  double felt() const { return felt_; }  ///< N, largest since contact was due
  Reading travel() const { return {travel_, limits_.late_contact_travel}; }     ///< m
  Reading lateness() const { return {waits_for_, limits_.late_contact_time}; }  ///< s

 private:
  ToolLimits limits_;
  double waits_for_ = 0.0, due_height_ = 0.0, travel_ = 0.0, felt_ = 0.0;
};

/// Contact that is wanted and lost.
class LossWatch {
 public:
  explicit LossWatch(const ToolLimits& limits) : limits_(limits) {}
  void reset() noexcept { lost_for_ = felt_ = 0.0; }
  /// force: N that is felt along the normal.
  Reading look(bool lost, double dt, double force) noexcept;
  double felt() const { return felt_; }  ///< N, largest since contact was lost

 private:
  ToolLimits limits_;
  double lost_for_ = 0.0, felt_ = 0.0;  ///< s, N
};

}  // namespace burnish::pressing
