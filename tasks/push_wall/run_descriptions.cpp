#include "push_wall/run_descriptions.hpp"

#include "push_wall/figures.hpp"

namespace burnish::push_wall {

const Description& description_of(const PushFigures* /*of*/) {
  static const Description all = [] {
    Describe<PushFigures> figures(
        "push_wall", "PushFigures",
        "Figures of the plant's true forces and positions. Forces are means over 10 ms. Forces of "
        "the hold are measured from 0.3 s after the ramp.");
    each_push_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

}  // namespace burnish::push_wall
