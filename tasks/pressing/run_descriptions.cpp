#include "pressing/run_descriptions.hpp"

#include "pressing/figures.hpp"

namespace burnish {

const Description& description_of(const TickTimes* /*of*/) {
  static const Description all = [] {
    Describe<TickTimes> figures("pressing", "TickTimes",
                                "Computing times of a controller's ticks after the first [s].");
    pressing::each_tick_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

}  // namespace burnish
