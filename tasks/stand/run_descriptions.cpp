#include "stand/run_descriptions.hpp"

#include "stand/figures.hpp"

namespace burnish::stand {

const Description& description_of(const SwayFigures* /*of*/) {
  static const Description all = [] {
    Describe<SwayFigures> figures(
        "stand", "SwayFigures",
        "Of the plant's true places, from where the sway begins to the end of the run or a fault.");
    each_sway_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>("stand", "Setting",
                  "A task with everything resolved: robot, start, feet, trunk, phases.")
          .field("robot", &S::robot)
          .required()
          .field("standing", &S::standing,
                 "the task's, with feet that were found where it states auto, or frames of which "
                 "the robot has none")
          .required()
          .field("q_start", &S::q_start, "nq")
          .required()
          .field("scene", &S::scene,
                 "as the controller knows it: the feet are its supports; its surface is the "
                 "ground, and its tip a small ball in the base that never touches it")
          .required()
          .field("base", &S::base, "a frame of the base's body")
          .required()
          .field("heading", &S::heading,
                 "axes that the sway is in, world: x forwards as the base is turned at the start, "
                 "z up")
          .required()
          .field("R_base", &S::R_base, "axes of that frame at the start, world")
          .required()
          .field("p_base", &S::p_base, "{m}, and its origin, world")
          .required()
          .field("com", &S::com, "{m}, centre of mass at the start, world")
          .required()
          .field("sway", &S::sway, "the task's, within what the feet allow where it is to fit")
          .field("notes", &S::notes, "sentences about what was found in place of what it says")
          .field("sway_end", &S::sway_end, "{s} of the schedule");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using R = RunSpec;
  static const Description all =
      Describe<R>("stand", "RunSpec", "A run of a task.")
          .field("task", &R::task)
          .field("setting", &R::setting, "of the task, where there is one already")
          .field("plant", &R::plant, "the ideal plant has no feet to stand on")
          .field("check_reach", &R::check_reach,
                 "before anything moves; a problem is then an Error")
          .field("plan_rate", &R::plan_rate, "{Hz}, at which plans are recorded; 0: none")
          .field("progress", &R::progress,
                 "Called now and then with the simulated time and about when it will be over, s. "
                 "Returning false stops the run.");
  return all;
}

}  // namespace burnish::stand
