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
       {&turned_, &turned_twice_, &speed_, &place_, &way_by_feet_, &place_by_feet_, &sum_})
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
  const double stays = std::exp(-dt / window_);
  const Vector3d turned_before = turned_;
  turned_ = stays * (turned_ + before_.R * beyond);
  turned_twice_ = stays * (turned_twice_ + turned_ - turned_before);
  const Vector3d way = by_feet.p - before_.p, way_before = way_by_feet_;
  way_by_feet_ = stays * (way_by_feet_ + way);
  place_by_feet_ = stays * (place_by_feet_ + way_by_feet_ - way_before);
  speed_ = stays * (speed_ + (before_.R * reading.accelerometer + gravity) * dt);
  place_ = stays * (place_ + speed_ * dt);
  speed_by_feet_ = stays * (speed_by_feet_ + v_by_feet - v_before_);
  v_before_ = v_by_feet;
  before_ = by_feet;
}

/// A unit that repeats itself says nothing, and a robot that sways looks like one that tips then.
UnitWatch::Tips UnitWatch::tips_over(const Vector3d& point, double least_turn,
                                     double least_place) const noexcept {
  if (repeats_for_ > 0.0 || !(turned_.norm() > least_turn)) return Tips::No;
  const Vector3d lever = before_.p - point, expected = turned_twice_.cross(lever);
  const double way = expected.norm();
  // About the line to the point, as the vertical, nothing moves, and nothing tips.
  if (way < 0.5 * turned_twice_.norm() * lever.norm()) return Tips::No;
  if (way < least_place) return Tips::Unclear;
  const double share = expected.dot(moved()) / (way * way);
  return share > 0.5 && share < 2.0 ? Tips::Yes : Tips::No;
}

Vector3d UnitWatch::mean_rate() const noexcept {
  return time_ > 0.0 ? Vector3d(sum_ / time_) : Vector3d::Zero();
}

}  // namespace burnish
