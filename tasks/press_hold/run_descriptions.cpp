#include "press_hold/run_descriptions.hpp"

#include "press_hold/figures.hpp"

namespace burnish::press_hold {

const Description& description_of(const HoldFigures* /*of*/) {
  static const Description all = [] {
    Describe<HoldFigures> figures("press_hold", "HoldFigures",
                                  "Figures from the end of the ramp to the end of the hold.");
    each_hold_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

}  // namespace burnish::press_hold
