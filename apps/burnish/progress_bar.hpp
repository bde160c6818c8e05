// The bar of long work on a terminal.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
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

}  // namespace burnish::app
