#include "polishing/run_descriptions.hpp"

#include "polishing/figures.hpp"

namespace burnish::polishing {

const Description& description_of(const VerdictFigures* /*of*/) {
  static const Description all = [] {
    Describe<VerdictFigures> figures("polishing", "VerdictFigures",
                                     "Metrics of a run, to compare with Verdict.");
    each_verdict_figure([&](const FigureEntry& entry, auto member, auto, bool) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

const Description& description_of(const RestFigures* /*of*/) {
  static const Description all = [] {
    Describe<RestFigures> figures(
        "polishing", "RestFigures",
        "Figures of the hand that rests on a plane, from the plant's true force and position.");
    each_rest_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

}  // namespace burnish::polishing
