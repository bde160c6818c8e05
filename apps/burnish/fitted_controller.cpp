#include "fitted_controller.hpp"

#include <fmt/format.h>

namespace burnish::app {

FittedController fit_controller(polishing::Task& task, const polishing::Setting& setting) {
  FittedController result{.fits_all = !task.model_error.transient_scale &&
                                      !task.model_error.bandwidth && !task.weights.position};
  result.fitted = polishing::fit_gains(task, setting);
  result.margins = polishing::margins(task, setting);
  return result;
}

void describe(const FittedController& controller, const std::string& place, bool talks) {
  if (!controller.margins) return;
  if (talks && !controller.fitted.changes.empty())
    fmt::print("{}: {}\n", place, controller.fitted.changes);
  if (talks) fmt::print("{}: the control loop tolerates {}\n", place, controller.margins->text());
  // Prints no warning if the user stated gains, or if the margins are met.
  if (!controller.fits_all || controller.fitted.meets) return;
  fmt::print(stderr,
             "burnish: {}: warning: the control loop tolerates {}; wanted {:g} ms of extra delay, "
             "and gains of 0.5 to 2 in each joint (model_error.transient_scale, "
             "model_error.bandwidth, weights.position)\n",
             place, controller.margins->text(), 1e3 * polishing::RequiredMargins{}.delay);
}

}  // namespace burnish::app
