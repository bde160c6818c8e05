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

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>("push_wall", "Setting",
                  "A task with everything resolved: robot, start, wall, feet, hands, phases.")
          .field("robot", &S::robot)
          .required()
          .field("q_start", &S::q_start, "nq")
          .required()
          .field("scene", &S::scene,
                 "as the controller knows it: feet and hands are its supports, in this order; its "
                 "surface is the wall, and its tip a smaller ball that never touches it")
          .required()
          .field("wall_axes", &S::wall_axes, "columns: two tangents and the normal, world")
          .required()
          .field("p_hands", &S::p_hands, "of the hands in contact, m, world; columns")
          .required()
          .field("com", &S::com, "centre of mass at the start, m, world")
          .required()
          .field("com_per_force", &S::com_per_force,
                 "m/N, world, level: how far the centre of mass goes per N of each hand so that "
                 "the pressure under the feet stays where it is")
          .required()
          .field("room", &S::room,
                 "{m} that the pressure lies before the middle of the feet at the start, on the "
                 "side of the wall")
          .field("touch", &S::touch, "{s} of the schedule")
          .field("ramp_end", &S::ramp_end, "{s} of the schedule")
          .field("hold_end", &S::hold_end, "{s} of the schedule")
          .field("lean_end", &S::lean_end, "{s} of the schedule")
          .field("top_end", &S::top_end, "{s} of the schedule")
          .field("release_end", &S::release_end, "{s} of the schedule");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using R = RunSpec;
  static const Description all =
      Describe<R>("push_wall", "RunSpec", "A run of a task.")
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

}  // namespace burnish::push_wall
