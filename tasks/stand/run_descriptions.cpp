#include "stand/run_descriptions.hpp"

#include "stand/figures.hpp"

namespace burnish::stand {

const Description& description_of(const SwayFigures* /*of*/) {
  static const Description all = [] {
    Describe<SwayFigures> figures("stand", "SwayFigures",
                                  "Figures of the plant's true positions, from the beginning of "
                                  "the sway to the end of the run "
                                  "or a fault.");
    each_sway_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

}  // namespace burnish::stand
