#include "fitted_controller.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace burnish::app {

FittedController fit_controller(polishing::Task& task, const polishing::Setting& setting,
                                const std::vector<document::Reader>& said) {
  const auto is_free = [&](const char* key) {
    return std::none_of(said.begin(), said.end(), [&](const document::Reader& text) {
      return files::stated(text, key).has_value();
    });
  };
  FittedController result{.free = {.boost = is_free("model_error.boost"),
                                   .bandwidth = is_free("model_error.bandwidth"),
                                   .position = is_free("weights.position")}};
  result.fitted = polishing::fit_gains(task, setting, result.free);
  result.margins = polishing::margins(task, setting);
  return result;
}

void describe(const FittedController& controller, const std::string& place, bool talks) {
  if (!controller.margins) return;
  if (talks && !controller.fitted.changes.empty())
    fmt::print("{}: {}\n", place, controller.fitted.changes);
  if (talks) fmt::print("{}: tolerates {}\n", place, controller.margins->text());
  // Whoever states gains is told what they tolerate, and no more.
  const polishing::FreeKeys& free = controller.free;
  if (!free.boost || !free.bandwidth || !free.position || controller.fitted.meets) return;
  fmt::print(stderr,
             "burnish: {}: warning: the loop tolerates {}; wanted {:g} ms, and half and twice the "
             "gain (model_error.boost, model_error.bandwidth, weights.position)\n",
             place, controller.margins->text(), 1e3 * polishing::RequiredMargins{}.delay);
}

}  // namespace burnish::app
