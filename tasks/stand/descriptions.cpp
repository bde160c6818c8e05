#include "stand/descriptions.hpp"

#include "mpc/descriptions.hpp"
#include "pressing/descriptions.hpp"
#include "pressing/task_form.hpp"
#include "sim/descriptions.hpp"

namespace burnish::stand {
namespace {

using T = Task;
constexpr Range positive = range::positive, not_negative = range::not_negative;

}  // namespace

const Description& description_of(const Sway* /*of*/) {
  using S = Sway;
  static const Description all =
      Describe<S>("stand", "Sway",
                  "How the trunk goes to and fro: a sine in each direction, begun and ended "
                  "smoothly. Axes are x forwards as the base is turned at the start, y to its "
                  "left, z up.")
          .field("shift", &S::shift, "{m}, amplitudes of the centre of mass: x, y, z")
          .field("shift_rate", &S::shift_rate, "{Hz}", not_negative)
          .field("turn", &S::turn, "{rad}, amplitudes of the base: roll, pitch, yaw")
          .field("turn_rate", &S::turn_rate, "{Hz}", not_negative)
          .field("rise", &S::rise, "{s} until it is that wide", positive)
          .field("fit", &S::fit,
                 "directions that the feet or the joints do not allow are left out, or made "
                 "smaller; false: a sway that cannot be followed is refused");
  return all;
}

const Description& description_of(const Weights* /*of*/) {
  using W = Weights;
  static const Description all =
      Describe<W>("stand", "Weights", "Cost weights, per second of horizon.")
          .field("posture", &W::posture, "{1/rad^2}: joints to the start", not_negative)
          .field("velocity", &W::velocity, "{s^2/rad^2}: joint speeds", not_negative)
          .field("torque", &W::torque, "{1/Nm^2}: torques to those that hold the start",
                 not_negative)
          .field("terminal", &W::terminal,
                 "{s}: what the end of the horizon costs, as a time at its running cost",
                 not_negative);
  return all;
}

namespace {

Describe<T>& describe_place(Describe<T>& task) {
  return task.field("robot", &T::robot, "a robot's name, folder or settings file, with :variant")
      .field("posture", &T::posture,
             "where it starts, of the robot's settings; search: found, on bent legs")
      .more("Empty: the robot's default, or searched where it has none.")
      .field("crouch", &T::crouch,
             "of the base's height above the feet with straight legs, that a searched posture is "
             "lower",
             range::fraction)
      .field("standing", &T::standing, "What the robot stands on.")
      .field("sway", &T::sway,
             "How the trunk goes to and fro: a sine in each direction, begun and ended smoothly.\n"
             "Axes are x forwards as the base is turned at the start, y to its left, z up.")
      .in_code("how the trunk goes to and fro");
}

Describe<T>& describe_phases(Describe<T>& task) {
  return task.group("Stand, sway, come back and stand.", "phases")
      .field("settle_duration", &T::settle_duration, "{s} of standing before it sways", positive)
      .field("sway_duration", &T::sway_duration, "{s} that it sways", positive)
      .field("rest_duration", &T::rest_duration, "{s} of standing afterwards", positive);
}

Describe<T>& describe_controller(Describe<T>& task) {
  task.group("", "controller")
      .field("tick_rate", &T::tick_rate, "{Hz}, of torque commands", range::from(100.0, 1e4))
      .field("update_rate", &T::update_rate, "{Hz}, of new plans; divides the tick rate", positive)
      .field("solver_delay", &T::solver_delay,
             "{s} from a measurement to the use of the plan made from it", not_negative);
  return pressing::describe_delays(task)
      .field("horizon", &T::horizon, "{s} that are planned ahead", positive)
      .field("step", &T::step, "{s} between the first two knots of the plan", positive)
      .field("knots", &T::knots, "of the plan; the steps grow so that they fill the horizon",
             range::from(2))
      .group("")
      .field("weights", &T::weights, "Cost weights, per second of horizon.")
      .field("model_error", &T::model_error, "What is estimated of what the model gets wrong.")
      .field("constraints", &T::constraints,
             "What plans keep, whatever it costs. Each may be never.");
}

Describe<T>& describe_rest(Describe<T>& task) {
  constexpr Range limit = range::positive_or_infinite;
  return task
      .group(
          "Beyond these a run is given up: the robot is braked and held (fallback), and there is a "
          "report.\nEach may be never.",
          "limits")
      .field("slip", &T::slip, "{m} that a foot may have slid; that a ball rolls is no sliding",
             limit)
      .field("sink", &T::sink,
             "of the height of the centre of mass above the feet, that it may be below where it is "
             "to be",
             limit)
      .field("tilt", &T::tilt, "{rad} that the base may be turned off what it is to be", limit)
      .field("limits", &T::limits, "")
      .group("");
}

}  // namespace

const Description& description_of(const Task* /*of*/) {
  static const Description all = [] {
    Describe<T> task("stand", "Task",
                     "The task of standing on feet and swaying: all that a task file may say, with "
                     "its defaults.");
    describe_place(task);
    describe_phases(task);
    describe_controller(task);
    describe_rest(task);
    return pressing::describe_disturbances(task);
  }();
  return all;
}

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Stand on feet, sway with the trunk and come back to rest: `burnish run`.\nSI units, "
        "angles in rad. A key that is left out has its default.",
        "stand");
    pressing::read_presets<Task>(form);
    const std::string nothing = "nothing is pressed";
    form.without("disturbances",
                 {"surface_tilt_deg", "surface_height", "surface_curvature", "surface_shape",
                  "surface_motion", "surface_friction"},
                 nothing)
        .without("model_error", {"sliding_bandwidth", "force_gain"}, nothing)
        .without("constraints", {"force_band"}, nothing)
        .without("constraints", {"joint_torque_rate"}, "plans of this task know no lag of torques");
    return form;
  }();
  return all;
}

}  // namespace burnish::stand
