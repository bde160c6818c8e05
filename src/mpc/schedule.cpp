#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/mpc/task.hpp"

namespace burnish {

namespace {

std::vector<std::string> named_events(const std::vector<SchedulePhase>& phases) {
  std::vector<std::string> events;
  for (const SchedulePhase& phase : phases)
    if (!phase.until.empty() &&
        std::find(events.begin(), events.end(), phase.until) == events.end())
      events.push_back(phase.until);
  return events;
}

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): its events are read before it is copied
Schedule::Schedule(std::vector<SchedulePhase> phases) : Schedule(phases, named_events(phases)) {}

Schedule::Schedule(std::vector<SchedulePhase> phases, std::vector<std::string> events)
    : phases_(std::move(phases)), events_(std::move(events)) {
  if (phases_.empty()) throw Error("a schedule has no phases; wanted at least one");
  if (events_.size() > 32)
    throw Error("a schedule has " + std::to_string(events_.size()) + " events; wanted at most 32");
  double start = 0.0;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const double duration = phases_[i].duration;
    if (!(duration > 0.0))
      throw Error("phase " + std::to_string(i) + " of a schedule lasts " + number(duration) +
                  " s; wanted a positive time");
    if (std::isinf(duration) && i + 1 < phases_.size())
      throw Error("phase " + std::to_string(i) +
                  " of a schedule never ends, but the number of phases after it is " +
                  std::to_string(phases_.size() - i - 1) + "; wanted 0");
    const std::string& until = phases_[i].until;
    const auto event = std::find(events_.begin(), events_.end(), until);
    if (!until.empty() && event == events_.end())
      throw Error("phase " + std::to_string(i) + " of a schedule waits for " + in_quotes(until) +
                  ", which is not an event of its task" + did_you_mean(until, events_));
    if (!until.empty() && !(phases_[i].hold > 0.0 && std::isfinite(phases_[i].hold)))
      throw Error("phase " + std::to_string(i) + " of a schedule waits for " + in_quotes(until) +
                  " with a hold of " + number(phases_[i].hold) + " s; wanted a positive time");
    until_.push_back(until.empty() ? 0U : 1U << (event - events_.begin()));
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
  while (phase + 1 < static_cast<int>(phases_.size()) && time >= starts_[to_size(phase) + 1])
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

bool Schedule::advance(double dt, unsigned happened) noexcept {
  time_ += dt;
  waits_ = false;
  for (; current_ + 1 < static_cast<int>(phases_.size()); ++current_) {
    const SchedulePhase& phase = phases_[to_size(current_)];
    const double end = start_of(current_ + 1);
    const unsigned until = until_[to_size(current_)];
    if ((until & happened) != 0) {
      const bool jumped = time_ != end;
      time_ = end;
      ++current_;
      return jumped;
    }
    if (until != 0) {
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
