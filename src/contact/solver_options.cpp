#include "burnish/contact/solver_options.hpp"

#include <cmath>
#include <string>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish {

void ContactSolver::check() const {
  if (!std::isfinite(mu) || mu < 0.0)
    throw Error("contact solver: mu is " + number(mu) + "; wanted a number >= 0");
  if (max_proximal_iterations < 0)
    throw Error("contact solver: max_proximal_iterations is " +
                std::to_string(max_proximal_iterations) + "; wanted 0 or more");
  if (!std::isfinite(proximal_tolerance) || proximal_tolerance < 0.0)
    throw Error("contact solver: proximal_tolerance is " + number(proximal_tolerance) +
                "; wanted a number >= 0");
}

}  // namespace burnish
