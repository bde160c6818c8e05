#include "push_wall/descriptions.hpp"

#include "mpc/descriptions.hpp"
#include "pressing/descriptions.hpp"
#include "pressing/task_form.hpp"
#include "sim/descriptions.hpp"

namespace burnish::push_wall {
namespace {

using T = Task;
constexpr Range positive = range::positive, not_negative = range::not_negative;

}  // namespace

const Description& description_of(const Weights* /*of*/) {
  using W = Weights;
  static const Description all =
      Describe<W>("push_wall", "Weights", "Cost weights, per second of horizon.")
          .field("force", &W::force, "{1/N^2}: of each hand along the normal to its target",
                 not_negative)
          .field("friction", &W::friction, "{1/N^2}: of each hand along the wall to none",
                 not_negative)
          .field("position", &W::position,
                 "{1/m^2}: hands to their places along the wall, while they do not hold",
                 not_negative)
          .field("approach", &W::approach,
                 "{s^2/m^2}: speed along the normal to that of approach and retreat", not_negative)
          .field("inclination", &W::inclination,
                 "{1/rad^2}: hands to their axis along the normal at the start; what tilts costs "
                 "torque of the wrists",
                 not_negative)
          .field("posture", &W::posture,
                 "{1/rad^2}: joints to the start; more keeps the body from leaning", not_negative)
          .field("range", &W::range,
                 "{1/rad^2}: joints off their limits, within range_margin of these", not_negative)
          .field("range_margin", &W::range_margin, "{rad (m)}", not_negative)
          .field("velocity", &W::velocity, "{s^2/rad^2}: joint speeds", not_negative)
          .field("torque", &W::torque, "{1/Nm^2}: torques to those that hold the start",
                 not_negative)
          .field("terminal", &W::terminal,
                 "{s}: what the end of the horizon costs, as a time at its running cost",
                 not_negative);
  return all;
}

const Description& description_of(const Wall* /*of*/) {
  using W = Wall;
  static const Description all =
      Describe<W>("push_wall", "Wall",
                  "A plane before the hands, and what plans keep of it. It lies `clearance` from "
                  "the nearer hand at the start.")
          .field("normal_world", &W::normal_world,
                 "[x, y, z] out of the wall towards the robot, any length, world", range::direction)
          .in_code("out of the wall, any length")
          .key("normal")
          .field("friction", &W::friction, "Coulomb coefficient of the plant", not_negative)
          .field("stiffness", &W::stiffness, "{N/m}, of the plant, under each hand", positive)
          .field("damping", &W::damping, "{Ns/m}, of the plant, under each hand", positive)
          .field("plan_friction", &W::plan_friction, "coefficient that plans keep within", positive)
          .field("contact_kd", &W::contact_kd,
                 "{1/s}, damping of the hands' constraint (Baumgarte)", not_negative);
  return all;
}

const Description& description_of(const Lean* /*of*/) {
  using L = Lean;
  static const Description all =
      Describe<L>("push_wall", "Lean",
                  "How the largest force is looked for, and when the search is over: where the "
                  "posture could not bear `reserve` more, where plans cannot keep their limits or "
                  "give way, where a hand or a foot slips, and at `force_max`.")
          .field("rate", &L::rate, "{N/s}, of each hand", positive)
          .field("force_max", &L::force_max, "{N} of each hand, where it ends at the latest",
                 range::positive_or_infinite)
          .more("never: nine tenths of limits.force.")
          .field(
              "reserve", &L::reserve,
              "of the force, that the posture must be able to bear beyond it, at rest and within "
              "the limits that plans keep",
              not_negative)
          .field("give", &L::give,
                 "{N} that the mean of both hands over 0.1 s may be below the target", positive)
          .field("slip", &L::slip,
                 "{m} that a hand or foot may slide within a second; grounds creep", positive)
          .field("share", &L::share, "of the force then, that is held afterwards", range::share)
          .field("hold_duration", &L::hold_duration, "{s} that this is held", positive);
  return all;
}

const Words& words_of(Limit /*of*/) {
  static const Words all{"push_wall",
                         "Limit",
                         "What ended the search for the largest force.",
                         {{"none", "nothing: the search did not end"},
                          {"most", "Lean.force_max was reached"},
                          {"bear", "the posture could not bear Lean.reserve more"},
                          {"give", "plans gave way: the hands fell behind the target"},
                          {"plan", "plans could not keep all their limits"},
                          {"hand", "a hand slipped"},
                          {"foot", "a foot slipped"}}};
  return all;
}

namespace {

Describe<T>& describe_place(Describe<T>& task) {
  return task.field("robot", &T::robot, "a robot's name, folder or settings file, with :variant")
      .field("posture", &T::posture, "where it starts, of the robot's settings")
      .more("Empty: the robot's default.")
      .field("force", &T::force, "{N}, that each hand presses with", positive)
      .field("hands", &T::hands, "two frames, whose origins are the centres of balls")
      .field("tip_radius", &T::tip_radius, "{m}, of those balls", positive)
      .field("wall", &T::wall,
             "A plane, `clearance` before the nearer hand at the start. The controller knows its "
             "normal.")
      .field("standing", &T::standing, "What the robot stands on.");
}

Describe<T>& describe_phases(Describe<T>& task) {
  return task
      .group(
          "Stand, approach until both hands have contact, ramp the force, hold it, lean to the "
          "largest,\nhold that, release, retreat.",
          "phases")
      .field("clearance", &T::clearance, "{m} between hands and wall at the start", positive)
      .field("settle_duration", &T::settle_duration, "{s} of standing before", positive)
      .field("approach_speed", &T::approach_speed, "{m/s} towards the wall", positive)
      .field("touch_force", &T::touch_force, "{N} of each hand, at once where both have contact",
             positive)
      .field("ramp_duration", &T::ramp_duration, "{s} from touch_force to force", positive)
      .field("hold_duration", &T::hold_duration, "{s} that the force is held", positive)
      .field("release_duration", &T::release_duration, "{s} back to touch_force", positive)
      .field("retreat_duration", &T::retreat_duration, "{s} off the wall, by the clearance",
             positive)
      .group("")
      .field("lean", &T::lean, "How the largest force is looked for, and when the search is over.");
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
      .field("force_limit", &T::force_limit, "{N} of a hand, mean over 5 ms", limit)
      .key("force")
      .field("slip", &T::slip, "{m} that a hand or foot may have slid", limit)
      .field("sink", &T::sink, "{m} that the centre of mass may be below where it starts", limit)
      .field("late_contact", &T::late_contact, "{s} that contact may come late", limit)
      .field("contact_lost", &T::contact_lost,
             "{s} that a hand may be without force while it is to press", limit)
      .field("contact_threshold", &T::contact_threshold,
             "{N}, mean over 10 ms, that count as contact of a hand", positive)
      .field("limits", &T::limits, "")
      .group("");
}

}  // namespace

const Description& description_of(const Task* /*of*/) {
  static const Description all = [] {
    Describe<T> task("push_wall", "Task",
                     "The task of pushing with both hands against a wall: all that a task file may "
                     "say, with its defaults.");
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
        "Push with both hands against a wall, and lean to the largest force: `burnish run`.\nSI "
        "units, angles in rad. A key that is left out has its default.",
        "push_wall");
    pressing::read_presets<Task>(form, "wall.friction");
    form.without("disturbances", {"surface_curvature", "surface_shape", "surface_motion"},
                 "the wall is a plane that stands")
        .without("model_error", {"sliding_bandwidth"}, "what hands press with is measured")
        .without("constraints", {"joint_torque_rate"}, "plans of this task know no lag of torques");
    return form;
  }();
  return all;
}

}  // namespace burnish::push_wall
