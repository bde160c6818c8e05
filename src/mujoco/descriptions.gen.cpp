// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "mujoco/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(MujocoContact /*of*/) {
  static const Words all{
      "sim",
      "MujocoContact",
      "What the tip meets in make_mujoco_plant()'s plant.",
      {{"exact", "a spring, a damper and Coulomb friction on the exact surface"},
       {"engine", "MuJoCo's own contact, of shapes that it has"}}};
  return all;
}

const Description& description_of(const MujocoPlantOptions* /*of*/) {
  using S = MujocoPlantOptions;
  static const Description all =
      Describe<S>("sim", "MujocoPlantOptions",
                  "How make_mujoco_plant()'s plant steps.")
          .field("contact", &S::contact,
                 "exact or engine")
          .field("dt", &S::dt,
                 "{s}",
                 {.least = 0, .open = true})
          .field("impedance", &S::impedance,
                 "d in (0, 1): 1/R is an apparent mass at the contact",
                 {.least = 0, .most = 1, .open = true})
          .field("friction_ratio", &S::friction_ratio,
                 "how much harder friction is than the normal (\"impratio\")",
                 {.least = 0, .open = true})
          .field("tolerance", &S::tolerance,
                 "of the constraint solver",
                 {.least = 0})
          .field("max_iterations", &S::max_iterations,
                 "of the constraint solver",
                 {.least = 1})
          .field("joint_stops", &S::joint_stops,
                 "revolute and prismatic joints stop at their limits");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
