#include "mujoco/descriptions.hpp"

namespace burnish {

const Words& words_of(MujocoContact /*of*/) {
  static const Words all{"sim",
                         "MujocoContact",
                         "What the tip meets in make_mujoco_plant()'s plant.",
                         {{"exact", "a spring, a damper and Coulomb friction on the exact surface"},
                          {"engine", "MuJoCo's own contact, of shapes that it has"}}};
  return all;
}

const Description& description_of(const MujocoPlantOptions* /*of*/) {
  using M = MujocoPlantOptions;
  static const Description all =
      Describe<M>("sim", "MujocoPlantOptions", "How make_mujoco_plant()'s plant steps.")
          .field("contact", &M::contact, "exact or engine")
          .field("dt", &M::dt, "{s}", range::positive)
          .field("impedance", &M::impedance, "d in (0, 1): 1/R is an apparent mass at the contact",
                 range::between(0, 1))
          .field("friction_ratio", &M::friction_ratio,
                 "how much harder friction is than the normal (\"impratio\")", range::positive)
          .field("tolerance", &M::tolerance, "of the constraint solver", range::not_negative)
          .field("max_iterations", &M::max_iterations, "of the constraint solver", range::from(1))
          .field("joint_stops", &M::joint_stops,
                 "revolute and prismatic joints stop at their limits");
  return all;
}

}  // namespace burnish
