#include "estimate/unit_watch.hpp"

#include <cmath>

namespace burnish {
namespace {

using Eigen::Vector3d;

}  // namespace

void UnitWatch::begin(const UnitPose& by_feet, const Vector3d& v_world) noexcept {
  begun_ = true;
  repeats_for_ = 0.0;
  before_ = by_feet;
  for (Vector3d* x :
       {&turned_, &turned_twice_, &speed_, &place_, &path_by_feet_, &place_by_feet_, &sum_})
    x->setZero();
  speed_ = speed_by_feet_ = v_before_ = v_world;
  time_ = 0.0;
}

void UnitWatch::advance(const ImuReading& reading, const UnitPose& by_feet,
                        const Vector3d& v_by_feet, const Vector3d& gravity, double dt) noexcept {
  const bool repeats = reading.gyro == last_.gyro && reading.accelerometer == last_.accelerometer;
  repeats_for_ = repeats ? repeats_for_ + dt : 0.0;
  last_ = reading;
  const Vector3d turn_by_feet = turn_of(before_.R.transpose() * by_feet.R);
  const Vector3d beyond = reading.gyro * dt - turn_by_feet;
  sum_ += beyond;
  time_ += dt;
  const double decay = std::exp(-dt / window_);
  const Vector3d turned_before = turned_;
  turned_ = decay * (turned_ + before_.R * beyond);
  turned_twice_ = decay * (turned_twice_ + turned_ - turned_before);
  const Vector3d path = by_feet.p - before_.p, path_before = path_by_feet_;
  path_by_feet_ = decay * (path_by_feet_ + path);
  place_by_feet_ = decay * (place_by_feet_ + path_by_feet_ - path_before);
  speed_ = decay * (speed_ + (before_.R * reading.accelerometer + gravity) * dt);
  place_ = decay * (place_ + speed_ * dt);
  speed_by_feet_ = decay * (speed_by_feet_ + v_by_feet - v_before_);
  v_before_ = v_by_feet;
  before_ = by_feet;
}

/// Returns whether the IMU moves like a body that turns about `point`. An IMU with repeated
/// readings is not evaluated, because it would make a swaying robot look like a tipping robot.
UnitWatch::Tips UnitWatch::tips_over(const Vector3d& point, double min_turn,
                                     double min_place) const noexcept {
  if (repeats_for_ > 0.0 || !(turned_.norm() > min_turn)) return Tips::No;
  const Vector3d lever = before_.p - point, expected = turned_twice_.cross(lever);
  const double distance = expected.norm();
  // A rotation about the line to `point`, for example about the vertical, displaces nothing and is
  // not tipping.
  if (distance < 0.5 * turned_twice_.norm() * lever.norm()) return Tips::No;
  if (distance < min_place) return Tips::Unclear;
  const double ratio = expected.dot(moved()) / (distance * distance);
  return ratio > 0.5 && ratio < 2.0 ? Tips::Yes : Tips::No;
}

Vector3d UnitWatch::mean_rate() const noexcept {
  return time_ > 0.0 ? Vector3d(sum_ / time_) : Vector3d::Zero();
}

}  // namespace burnish
