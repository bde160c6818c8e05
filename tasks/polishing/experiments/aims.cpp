#include "polishing/experiments/aims.hpp"

#include <cmath>
#include <cstdio>

namespace burnish::polishing {

std::string verdict(double value, const Aim& aim) {
  if (!std::isfinite(value)) return "missed: no value";
  if (value <= aim.limit + 1e-9) return "met";
  char text[80];
  const char* const unit = figure_named(aim.figure).unit.shown;
  if (aim.limit > 0.0)
    std::snprintf(text, sizeof text, "missed by %.3g %s (%.0f %%)", value - aim.limit, unit,
                  100.0 * (value / aim.limit - 1.0));
  else
    std::snprintf(text, sizeof text, "missed by %.3g %s", value, unit);
  return text;
}

ResultCell room_below(double value, const Aim& aim) {
  if (!(aim.limit > 0.0)) return std::monostate();
  return 100.0 * (1.0 - value / aim.limit);
}

}  // namespace burnish::polishing
