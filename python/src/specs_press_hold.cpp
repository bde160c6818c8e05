#include "specs_press_hold.hpp"

#include "press_hold/figures.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<press_hold::Setting>::table() {
  using press_hold::Setting;
  static const SpecTable fields = SpecTable("burnish.press_hold", "Setting")
                                      .field("robot", &Setting::robot)
                                      .field("q_start", &Setting::q_start)
                                      .field("q_aside", &Setting::q_aside)
                                      .field("scene", &Setting::scene)
                                      .field("surface_axes", &Setting::surface_axes)
                                      .field("p_hold", &Setting::p_hold)
                                      .field("touch", &Setting::touch)
                                      .field("ramp_end", &Setting::ramp_end)
                                      .field("hold_end", &Setting::hold_end);
  return fields;
}
template <>
const SpecTable& AsDataclass<press_hold::RunSpec>::table() {
  using press_hold::RunSpec;
  static const SpecTable fields = SpecTable("burnish.press_hold", "RunSpec")
                                      .field("task", &RunSpec::task)
                                      .field("setting", &RunSpec::setting)
                                      .field("plant", &RunSpec::plant)
                                      .field("check_reach", &RunSpec::check_reach)
                                      .field("plan_rate", &RunSpec::plan_rate)
                                      .field("progress", &RunSpec::progress);
  return fields;
}
template <>
const SpecTable& AsDataclass<press_hold::HoldFigures>::table() {
  static const SpecTable fields = [] {
    SpecTable table("burnish.press_hold", "HoldFigures");
    press_hold::each_hold_figure(
        [&](const FigureEntry& entry, auto member) { table.field(entry.name, member); });
    return table;
  }();
  return fields;
}

}  // namespace burnish::python
