// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "mujoco/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(MujocoContact /*of*/) {
  static const Words all{
      "sim",
      "MujocoContact",
      "Contact model of tools in a MuJoCo plant.",
      {{"exact", "Spring, damper and Coulomb friction on the exact surface"},
       {"engine", "MuJoCo's own contact, for the shapes that it supports"}}};
  return all;
}

const Description& description_of(const MujocoPlantOptions* /*of*/) {
  using S = MujocoPlantOptions;
  static const Description all =
      Describe<S>("sim", "MujocoPlantOptions",
                  "Options of the plant that make_mujoco_plant() creates.")
          .field("contact", &S::contact,
                 "Contact model: exact or engine")
          .field("dt", &S::dt,
                 "Time step [{s}]",
                 {.least = 0, .open = true})
          .field("impedance", &S::impedance,
                 "Impedance d of MuJoCo's own contact",
                 {.least = 0, .most = 1, .open = true})
          .more("The contact acts with an apparent mass of d / (1 - d) times the apparent mass of"
                " the tip.")
          .field("friction_ratio", &S::friction_ratio,
                 "Ratio of frictional to normal impedance (MuJoCo's impratio)",
                 {.least = 0, .open = true})
          .field("tolerance", &S::tolerance,
                 "Tolerance of the constraint solver",
                 {.least = 0})
          .field("max_iterations", &S::max_iterations,
                 "Maximum number of iterations of the constraint solver",
                 {.least = 1})
          .field("joint_stops", &S::joint_stops,
                 "Whether revolute and prismatic joints stop at their limits");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
