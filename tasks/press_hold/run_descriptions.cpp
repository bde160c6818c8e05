#include "press_hold/run_descriptions.hpp"

#include "press_hold/figures.hpp"

namespace burnish::press_hold {

const Description& description_of(const HoldFigures* /*of*/) {
  static const Description all = [] {
    Describe<HoldFigures> figures("press_hold", "HoldFigures",
                                  "Of the time from the end of the ramp to the end of the hold.");
    each_hold_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>("press_hold", "Setting",
                  "A task with everything resolved: robot, start, surface, phases.")
          .field("robot", &S::robot)
          .required()
          .field("q_start", &S::q_start, "nq, where the posture's reference begins")
          .required()
          .field("q_aside", &S::q_aside, "nq, where it ends")
          .required()
          .field("scene", &S::scene, "as the controller knows it")
          .required()
          .field("surface_axes", &S::surface_axes, "columns: two tangents and the normal, world")
          .required()
          .field("p_hold", &S::p_hold, "of the tool in contact, m, world")
          .required()
          .field("touch", &S::touch, "{s} of the schedule")
          .field("ramp_end", &S::ramp_end, "{s} of the schedule")
          .field("hold_end", &S::hold_end, "{s} of the schedule");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using R = RunSpec;
  static const Description all =
      Describe<R>("press_hold", "RunSpec", "A run of a task.")
          .field("task", &R::task)
          .field("setting", &R::setting, "of the task, where there is one already")
          .field("plant", &R::plant, "MuJoCo where this build has it")
          .field("check_reach", &R::check_reach,
                 "before anything moves; a problem is then an Error")
          .field("plan_rate", &R::plan_rate, "{Hz}, at which plans are recorded; 0: none")
          .field("progress", &R::progress,
                 "Called now and then with the simulated time and about when it will be over, s. "
                 "Returning false stops the run.");
  return all;
}

}  // namespace burnish::press_hold
