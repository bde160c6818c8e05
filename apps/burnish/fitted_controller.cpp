#include "fitted_controller.hpp"

#include <fmt/format.h>

namespace burnish::app {

FittedController fit_controller(polishing::Task& task, const polishing::Setting& setting) {
  FittedController result{.fits_all = !task.model_error.boost && !task.model_error.bandwidth &&
                                      !task.weights.position};
  result.fitted = polishing::fit_gains(task, setting);
  result.margins = polishing::margins(task, setting);
  return result;
}

void describe(const FittedController& controller, const std::string& place, bool talks) {
  if (!controller.margins) return;
  if (talks && !controller.fitted.changes.empty())
    fmt::print("{}: {}\n", place, controller.fitted.changes);
  if (talks) fmt::print("{}: tolerates {}\n", place, controller.margins->text());
  // Whoever states gains is told what they tolerate, and no more.
  if (!controller.fits_all || controller.fitted.meets) return;
  fmt::print(stderr,
             "burnish: {}: warning: the loop tolerates {}; wanted {:g} ms, and half and twice the "
             "gain (model_error.boost, model_error.bandwidth, weights.position)\n",
             place, controller.margins->text(), 1e3 * polishing::RequiredMargins{}.delay);
}

}  // namespace burnish::app
