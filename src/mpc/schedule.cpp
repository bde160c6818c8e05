#include "burnish/mpc/schedule.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish {

Schedule::Schedule(std::vector<SchedulePhase> phases) : phases_(std::move(phases)) {
  if (phases_.empty()) throw Error("a schedule has no phases; wanted at least one");
  double start = 0.0;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const double duration = phases_[i].duration;
    if (!(duration > 0.0))
      throw Error("phase " + std::to_string(i) + " of a schedule lasts " + number(duration) +
                  " s; wanted a positive time");
    if (std::isinf(duration) && i + 1 < phases_.size())
      throw Error("phase " + std::to_string(i) + " of a schedule never ends, but " +
                  std::to_string(phases_.size() - i - 1) + " follow it");
    if (phases_[i].until_contact && !(phases_[i].hold > 0.0 && std::isfinite(phases_[i].hold)))
      throw Error("phase " + std::to_string(i) +
                  " of a schedule waits for contact with a hold of " + number(phases_[i].hold) +
                  " s; wanted a positive time");
    starts_.push_back(start);
    start += duration;
  }
}

void Schedule::reset() noexcept {
  time_ = 0.0;
  waits_ = false;
  current_ = 0;
}

int Schedule::phase_at(double time) const noexcept {
  int phase = 0;
  while (phase + 1 < static_cast<int>(phases_.size()) &&
         time >= starts_[static_cast<std::size_t>(phase) + 1])
    ++phase;
  return phase;
}

bool Schedule::finished() const noexcept {
  return std::isfinite(phases_.back().duration) &&
         time_ >= starts_.back() + phases_.back().duration;
}

void Schedule::jump_to(int phase) noexcept {
  current_ = std::clamp(phase, 0, static_cast<int>(phases_.size()) - 1);
  time_ = start_of(current_);
  waits_ = false;
}

bool Schedule::advance(double dt, bool contact) noexcept {
  time_ += dt;
  waits_ = false;
  for (; current_ + 1 < static_cast<int>(phases_.size()); ++current_) {
    const SchedulePhase& phase = phases_[static_cast<std::size_t>(current_)];
    const double end = start_of(current_ + 1);
    if (phase.until_contact && contact) {
      const bool jumped = time_ != end;
      time_ = end;
      ++current_;
      return jumped;
    }
    if (phase.until_contact) {
      const double latest = std::max(start_of(current_), end - phase.hold);
      waits_ = time_ > latest;
      time_ = std::min(time_, latest);
      return waits_;
    }
    if (time_ < end) return false;
  }
  return false;
}

}  // namespace burnish
