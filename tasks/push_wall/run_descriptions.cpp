#include "push_wall/run_descriptions.hpp"

#include "push_wall/figures.hpp"

namespace burnish::push_wall {

const Description& description_of(const PushFigures* /*of*/) {
  static const Description all = [] {
    Describe<PushFigures> figures(
        "push_wall", "PushFigures",
        "Of the plant's true forces and places. Forces are means over 10 ms; the hold's are of the "
        "time from 0.3 s after the ramp.");
    each_push_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using R = RunSpec;
  static const Description all =
      Describe<R>("push_wall", "RunSpec", "A run of a task.")
          .field("task", &R::task)
          .field("plant", &R::plant, "the ideal plant has no feet to stand on")
          .field("check_reach", &R::check_reach,
                 "before anything moves; a problem is then an Error")
          .field("plan_rate", &R::plan_rate, "{Hz}, at which plans are recorded; 0: none")
          .field("progress", &R::progress,
                 "Called now and then with the simulated time and about when it will be over, s. "
                 "Returning false stops the run.");
  return all;
}

}  // namespace burnish::push_wall
