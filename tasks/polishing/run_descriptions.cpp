#include "polishing/run_descriptions.hpp"

#include "polishing/figures.hpp"

namespace burnish::polishing {

const Description& description_of(const VerdictFigures* /*of*/) {
  static const Description all = [] {
    Describe<VerdictFigures> figures("polishing", "VerdictFigures",
                                     "What Verdict is about, as it was in a run.");
    each_verdict_figure([&](const FigureEntry& entry, auto member, auto, bool) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

const Words& words_of(ControllerKind /*of*/) {
  static const Words all{
      "polishing",
      "ControllerKind",
      "What controls a run.",
      {{"mpc", "model predictive control (MpcController)"},
       {"baseline", "impedance with force feedback, no optimisation (make_impedance_controller())"},
       {"admittance",
        "force error to joint positions that are held (make_admittance_controller())"}}};
  return all;
}

const Description& description_of(const NamedSurface* /*of*/) {
  using N = NamedSurface;
  static const Description all =
      Describe<N>(
          "polishing", "NamedSurface",
          "A surface by name: where its normal points and a starting posture of the robot for it.")
          .result()
          .field("name", &N::name)
          .field("posture", &N::posture, "of the robot's settings")
          .field("normal_world", &N::normal_world, "out of the surface");
  return all;
}

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>(
          "polishing", "Setting",
          "A task with everything resolved: robot, start, surface, path in the world, phases.")
          .field("robot", &S::robot)
          .required()
          .field("q_start", &S::q_start, "nq")
          .required()
          .field("scene", &S::scene, "as the controller knows it")
          .required()
          .field("surface_axes", &S::surface_axes, "columns: two tangents and the normal, world")
          .required()
          .field("p_start", &S::p_start, "of the tool, m, world")
          .required()
          .field("p_center", &S::p_center, "of the tool at the path's origin in contact, m, world")
          .required()
          .field("reach_end", &S::reach_end, "{s} of the schedule")
          .field("touch", &S::touch, "{s} of the schedule")
          .field("ramp_end", &S::ramp_end, "{s} of the schedule")
          .field("track_end", &S::track_end, "{s} of the schedule")
          .field("assumed_rotors", &S::assumed_rotors,
                 "kg m^2 (kg) by joint, that Task.assume_rotors added to the robot's armature")
          .field("home", &S::home, "from where a run begins (Task.home) to q_start");
  return all;
}

const Description& description_of(const FreeHome* /*of*/) {
  using F = FreeHome;
  static const Description all =
      Describe<F>("polishing", "FreeHome",
                  "Posture of a robot from which its joints can move straight to a task's start.")
          .result()
          .field("posture", &F::posture, "of the robot's settings")
          .field("duration", &F::duration, "{s}, of the move");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using R = RunSpec;
  static const Description all =
      Describe<R>("polishing", "RunSpec", "A run of a task.")
          .field("task", &R::task)
          .field("robot", &R::robot, "in place of the one that the task names")
          .field("controller", &R::controller)
          .field("plant", &R::plant, "MuJoCo where this build has it")
          .field("check_reach", &R::check_reach,
                 "before anything moves; a problem is then an Error")
          .field("reach", &R::reach)
          .field("plan_rate", &R::plan_rate,
                 "{Hz}, at which plans of the MPC are recorded, at most 20 000 of them; 0: none")
          .field("progress", &R::progress,
                 "Called now and then with the simulated time and about when it will be over, s. "
                 "Returning false stops the run.");
  return all;
}

const Description& description_of(const RequiredMargins* /*of*/) {
  using R = RequiredMargins;
  static const Description all =
      Describe<R>("polishing", "RequiredMargins",
                  "Margins that every arm must have beyond the delays and filters of its loop.")
          .field("delay", &R::delay, "{s}, extra delay of the commands", range::not_negative)
          .field("gain", &R::gain, "factor on one joint's torque; also its inverse",
                 range::positive);
  return all;
}

const Description& description_of(const TaskMargins* /*of*/) {
  using T = TaskMargins;
  static const Description all =
      Describe<T>("polishing", "TaskMargins",
                  "Stability margins of a polishing task's loop at its starting posture.")
          .result()
          .field("air", &T::air, "in free air")
          .field("contact", &T::contact, "with the tool on the surface");
  return all;
}

const Description& description_of(const FittedGains* /*of*/) {
  using F = FittedGains;
  static const Description all =
      Describe<F>("polishing", "FittedGains", "Result of fit_gains().")
          .result()
          .field("meets", &F::meets, "true if the required margins are met, or cannot be computed")
          .field("changes", &F::changes,
                 "sentence that names the fitted gains; empty if none was fitted");
  return all;
}

}  // namespace burnish::polishing
