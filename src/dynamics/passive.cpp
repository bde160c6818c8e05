#include "dynamics/passive.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish {

PassiveJoints::PassiveJoints(const Model& model, double slip_velocity)
    : damping(model.damping.data(), model.damping.data() + model.damping.size()),
      friction(model.friction.data(), model.friction.data() + model.friction.size()),
      springs(model),
      slip(slip_velocity) {
  if (slip > 0.0 && std::isfinite(slip)) return;
  throw Error("slip_velocity is " + number(slip_velocity) +
              "; wanted a positive number in rad/s or m/s");
}

}  // namespace burnish
