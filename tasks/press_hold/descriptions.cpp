#include "press_hold/descriptions.hpp"

#include "mpc/descriptions.hpp"
#include "pressing/descriptions.hpp"
#include "pressing/task_form.hpp"
#include "sim/descriptions.hpp"

namespace burnish::press_hold {
namespace {

using T = Task;
constexpr Range positive = range::positive, positive_or_endless = range::positive_or_infinite;

Describe<T>& describe_place(Describe<T>& task) {
  task.field("robot", &T::robot, "a robot's name, folder or settings file, with :variant")
      .field("posture", &T::posture, "where it starts; search: found for the surface")
      .more("Of the robot's settings. Empty: the robot's default, or searched where it has none.")
      .field("force", &T::force, "{N}, that the tool presses with", positive)
      .field("aside", &T::aside,
             "{rad (m)} that the posture goes, joint by joint: {joint: way, ...}");
  pressing::describe_tool(task)
      .group("It lies `clearance` below the tool at the start. The controller knows its normal.",
             "surface")
      .field("normal_world", &T::normal_world,
             "[x, y, z] out of the material towards the robot, any length, world", range::direction)
      .in_code("out of the surface, any length")
      .key("normal")
      .field("extent", &T::extent,
             "{m} that there is surface beyond the point, on all four sides; or endless",
             positive_or_endless)
      .word("endless");
  return pressing::describe_material(task).field("search", &T::search,
                                                 "What a posture that is searched keeps to.");
}

Describe<T>& describe_rest(Describe<T>& task) {
  task.group("Approach until contact, ramp the force, move aside, hold, retreat.", "phases")
      .field("clearance", &T::clearance, "{m} between tool and surface at the start", positive)
      .field("approach_speed", &T::approach_speed, "{m/s} towards the surface", positive)
      .field("touch_force", &T::touch_force, "{N}, at once where contact is made",
             range::not_negative)
      .field("ramp_duration", &T::ramp_duration, "{s} from touch_force to force", positive)
      .field("aside_duration", &T::aside_duration, "{s} that the posture takes to go aside",
             positive)
      .field("hold_duration", &T::hold_duration, "{s} that it stays there", positive)
      .field("retreat_duration", &T::retreat_duration, "{s} off the surface, by the clearance",
             positive)
      .group("", "controller")
      .field("tick_rate", &T::tick_rate, "{Hz}, of torque commands and of new plans",
             range::from(100.0, 1e4));
  pressing::describe_delays(task)
      .field("posture_weight", &T::posture_weight,
             "{1/rad^2}: joints to where they shall be, beside 1e4 1/m^2 of the point", positive)
      .field("constraints", &T::constraints,
             "What plans keep, whatever it costs. Each may be never.");
  pressing::describe_limits(task)
      .field("slip", &T::slip, "{m} that the tool may be off its point, along the surface",
             range::positive_or_infinite)
      .group("");
  return pressing::describe_disturbances(task);
}

}  // namespace

const Description& description_of(const Task* /*of*/) {
  static const Description all = [] {
    Describe<T> task("press_hold", "Task",
                     "The task of pressing at a point while the arm moves aside: all that a task "
                     "file may say, with its defaults.");
    describe_place(task);
    return describe_rest(task);
  }();
  return all;
}

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Press at a point and hold the force while the rest of the arm moves aside: `burnish "
        "run`.\nSI units, angles in rad. A key that is left out has its default.",
        "press_hold");
    pressing::read_presets<Task>(form, "surface.friction");
    const std::string fixed = "the robot's base is fixed";
    form.without("disturbances", pressing::disturbances_of_standing(), fixed)
        .without("limits", {"base_lost", "support_way"}, fixed)
        .without("constraints", {"joint_torque_rate"}, "plans of this task know no lag of torques");
    form.first("limits", {"force", "slip"});
    return form;
  }();
  return all;
}

}  // namespace burnish::press_hold
