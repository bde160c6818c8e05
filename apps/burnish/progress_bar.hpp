// Progress bar with the remaining time, for long work on a terminal.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

namespace burnish::app {

/// Draws a progress bar over the current line of the standard error, which must be a terminal.
/// `done`: completed fraction, clamped to 0 to 1; `what`: text after the bar.
inline void show_progress(const std::string& name, double done, const std::string& what) {
  constexpr int width = 30;
  const double fraction = std::clamp(done, 0.0, 1.0);
  const int filled = static_cast<int>(fraction * width);
  fmt::print(stderr, "\r\033[K{} [{:#<{}}{:.<{}}] {:3.0f} %  {}", name, "", filled, "",
             width - filled, 100.0 * fraction, what);
  std::fflush(stderr);
}

/// Estimate of the remaining time. It extrapolates the progress since the first call.
class RemainingTime {
 public:
  /// Returns a text such as "4 min left, "; empty while too little is done for an estimate. `done`:
  /// completed fraction.
  std::string text(double done) {
    const Clock::time_point now = Clock::now();
    if (!begin_) begin_ = now, first_done_ = done;
    const double passed = std::chrono::duration<double>(now - *begin_).count();
    if (passed < 2.0 || done - first_done_ < 1e-3) return "";
    const double left = passed * std::max(0.0, 1.0 - done) / (done - first_done_);
    if (left < 90.0) return fmt::format("{:.0f} s left, ", left);
    return left < 5400.0 ? fmt::format("{:.0f} min left, ", left / 60.0)
                         : fmt::format("{:.1f} h left, ", left / 3600.0);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> begin_;
  double first_done_ = 0.0;  ///< Completed fraction at the first call.
};

/// Progress of a run. On a terminal, it is a bar with the remaining time; elsewhere, one sentence
/// if the run takes long.
class RunProgressText {
 public:
  RunProgressText(std::string name, bool bar) : name_(std::move(name)), bar_(bar) {}
  void show(double time, double end) {
    // The sentence is printed if the elapsed and the remaining time both exceed these limits [s];
    // chosen by hand.
    constexpr double min_elapsed = 10.0, min_remaining = 60.0;
    const double done = time / std::max(end, 1e-9);
    const std::string left = left_.text(done);
    if (bar_)
      return show_progress(name_, done, fmt::format("{}{:.1f} s of {:.1f} s", left, time, end));
    const double passed = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (said_ || passed < min_elapsed || left.empty()) return;
    if (passed * (1.0 - done) < min_remaining * done) return;
    said_ = true;
    fmt::print(stderr, "burnish: {}: {}Ctrl-C ends it and writes the results so far\n", name_,
               left);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::string name_;
  bool bar_ = false, said_ = false;
  Clock::time_point begin_ = Clock::now();
  RemainingTime left_;
};

}  // namespace burnish::app
