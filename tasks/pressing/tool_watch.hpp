// Monitors of a pressing tool. Each compares one quantity with its limit: force in free space,
// travel until contact, time without contact.
#pragma once

#include "burnish/tasks/pressing/pressing_task.hpp"
#include "estimate/contact_detector.hpp"

namespace burnish::pressing {

/// Returns the number of ticks in `time` [s], at least 1.
int samples_of(double time, double tick_period);

/// Mean of the measured force over a time window.
class MeanForce {
 public:
  explicit MeanForce(int samples) : ring_(Eigen::Matrix3Xd::Zero(3, samples)) {}
  void reset() noexcept;
  void add(const Eigen::Vector3d& force) noexcept;
  /// Returns the mean over the window [N]. Until the window is full, it is the mean over all
  /// samples.
  const Eigen::Vector3d& value() const { return mean_; }
  int samples() const { return static_cast<int>(ring_.cols()); }
  bool is_full() const { return count_ >= ring_.cols(); }

 private:
  Eigen::Matrix3Xd ring_;
  long count_ = 0;
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
};

/// Monitor of the force in free space. At the start of the phase Touch::Leaving, the tool still
/// presses. The tool counts as free once it has been off the surface for longer than a bounce
/// takes.
class FreeSpaceWatch {
 public:
  FreeSpaceWatch(const ToolLimits& limits, double contact_threshold)
      : limits_(limits), threshold_(contact_threshold) {}
  void reset() noexcept;
  /// Updates the monitor and returns the force with its limit. `pushed`: mean force along the
  /// normal [N]. `touch`: detector that provides the noise level.
  Reading look(Touch phase, double dt, double pushed, const MeanForce& mean,
               const ContactDetector& touch) noexcept;

 private:
  ToolLimits limits_;
  double threshold_;
  /// Time in the phase Leaving, and time off the surface [s].
  double leaves_for_ = 0.0, off_for_ = 0.0;
  bool released_ = false;  ///< True once the tool is off the surface, or should be by now.
};

/// Monitor of contact that comes later than planned.
class ApproachWatch {
 public:
  explicit ApproachWatch(const ToolLimits& limits) : limits_(limits) {}
  void reset() noexcept { waits_for_ = due_height_ = travel_ = felt_ = 0.0; }
  /// Updates the monitor. `height`: height of the tool along the normal [m]. `force`: measured
  /// force along the normal [N].
  void look(bool waits, double dt, double height, double force) noexcept;
  double felt() const { return felt_; }  ///< Largest force since contact was due [N].
  /// Returns the tool's travel towards the surface since contact was due, with its limit [m].
  Reading travel() const { return {travel_, limits_.late_contact_travel}; }
  /// Returns the time since contact was due, with its limit [s].
  Reading lateness() const { return {waits_for_, limits_.late_contact_time}; }

 private:
  ToolLimits limits_;
  double waits_for_ = 0.0, due_height_ = 0.0, travel_ = 0.0, felt_ = 0.0;
};

/// Monitor of the loss of contact.
class LossWatch {
 public:
  explicit LossWatch(const ToolLimits& limits) : limits_(limits) {}
  void reset() noexcept { lost_for_ = felt_ = 0.0; }
  /// Updates the monitor and returns the time without contact, with its limit. `force`: measured
  /// force along the normal [N].
  Reading look(bool lost, double dt, double force) noexcept;
  double felt() const { return felt_; }  ///< Largest force since contact was lost [N].

 private:
  ToolLimits limits_;
  /// Time without contact [s], and largest force during this time [N].
  double lost_for_ = 0.0, felt_ = 0.0;
};

}  // namespace burnish::pressing
