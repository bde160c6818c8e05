#include "pressing/tool_watch.hpp"

#include <algorithm>
#include <cmath>

namespace burnish::pressing {

int samples_of(double time, double tick_period) {
  return static_cast<int>(std::max(1.0, std::round(time / tick_period)));
}

void MeanForce::reset() noexcept {
  count_ = 0;
  mean_.setZero();
}

void MeanForce::add(const Eigen::Vector3d& force) noexcept {
  ring_.col(count_ % ring_.cols()) = force;
  ++count_;
  const Eigen::Index count = std::min<Eigen::Index>(count_, ring_.cols());
  mean_ = ring_.leftCols(count).rowwise().sum() / static_cast<double>(count);
}

void FreeSpaceWatch::reset() noexcept {
  leaves_for_ = off_for_ = 0.0;
  released_ = false;
}

Reading FreeSpaceWatch::look(Touch phase, double dt, double pushed, const MeanForce& mean,
                             const ContactDetector& touch) noexcept {
  const bool leaves = phase == Touch::Leaving;
  leaves_for_ = leaves ? leaves_for_ + dt : 0.0;
  // Time that is longer than a bounce of the tool off the surface [s]. Chosen by hand.
  constexpr double bounce = 0.04;
  off_for_ = leaves && pushed < threshold_ ? off_for_ + dt : 0.0;
  released_ = leaves && (released_ || off_for_ > bounce || leaves_for_ > limits_.release);
  if ((phase != Touch::Free && !released_) || !mean.is_full()) return {};
  return {pushed, touch.above_noise(limits_.unexpected_force, mean.samples())};
}

void ApproachWatch::look(bool waits, double dt, double height, double force) noexcept {
  const bool waited = waits_for_ > 0.0;
  waits_for_ = waits ? waits_for_ + dt : 0.0;
  if (waits && !waited) due_height_ = height;
  travel_ = waits ? due_height_ - height : 0.0;
  felt_ = waits && waited ? std::max(felt_, force) : force;
}

Reading LossWatch::look(bool lost, double dt, double force) noexcept {
  felt_ = lost && lost_for_ > 0.0 ? std::max(felt_, force) : force;
  lost_for_ = lost ? lost_for_ + dt : 0.0;
  return {lost_for_, limits_.contact_lost};
}

}  // namespace burnish::pressing
