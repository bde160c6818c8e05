// The bar of long work on a terminal.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

namespace burnish::app {

/// Draws over the line before on the standard error. `share`: what is done, 0 to 1 (more is cut
/// off); `what`: at the end of the line. For terminals alone: whoever calls has asked isatty().
inline void show_progress(const std::string& name, double share, const std::string& what) {
  constexpr int width = 30;
  const double part = std::clamp(share, 0.0, 1.0);
  const int done = static_cast<int>(part * width);
  fmt::print(stderr, "\r\033[K{} [{:#<{}}{:.<{}}] {:3.0f} %  {}", name, "", done, "", width - done,
             100.0 * part, what);
  std::fflush(stderr);
}

/// How long what is left takes, by what was done since the first call.
class RemainingTime {
 public:
  /// Such as "4 min left, "; empty while too little is done to tell.
  std::string text(double share) {
    const Clock::time_point now = Clock::now();
    if (!begin_) begin_ = now, share_ = share;
    const double passed = std::chrono::duration<double>(now - *begin_).count();
    if (passed < 2.0 || share - share_ < 1e-3) return "";
    const double left = passed * std::max(0.0, 1.0 - share) / (share - share_);
    if (left < 90.0) return fmt::format("{:.0f} s left, ", left);
    return left < 5400.0 ? fmt::format("{:.0f} min left, ", left / 60.0)
                         : fmt::format("{:.1f} h left, ", left / 3600.0);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> begin_;
  double share_ = 0.0;  ///< that was done by then
};

/// How far a run is: a bar with the time that is left on a terminal, elsewhere one sentence when
/// the run turns out to be long.
class RunProgressText {
 public:
  RunProgressText(std::string name, bool bar) : name_(std::move(name)), bar_(bar) {}
  void tell(double time, double end) {
    constexpr double patience = 10.0, worth_saying = 60.0;  // s
    const double share = time / std::max(end, 1e-9);
    const std::string left = left_.text(share);
    if (bar_)
      return show_progress(name_, share, fmt::format("{}{:.1f} s of {:.1f} s", left, time, end));
    const double passed = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (said_ || passed < patience || left.empty()) return;
    if (passed * (1.0 - share) < worth_saying * share) return;
    said_ = true;
    fmt::print(stderr, "burnish: {}: {}Ctrl-C ends it and writes what there is\n", name_, left);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::string name_;
  bool bar_ = false, said_ = false;
  Clock::time_point begin_ = Clock::now();
  RemainingTime left_;
};

}  // namespace burnish::app
