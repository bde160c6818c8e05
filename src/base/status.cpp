#include "burnish/base/status.hpp"

namespace burnish {

std::string_view describe(Status status) {
  switch (status) {
    case Status::Ok:
      return "ok";
    case Status::NotConverged:
      return "the proximal iterations stopped above their tolerance: allow more iterations or "
             "lower mu, unless contact rows contradict each other";
    case Status::SingularContacts:
      return "the contacts are redundant or cannot be held by the joints at this posture: call "
             "diagnose() for their names, or set mu > 0";
    case Status::SingularMass:
      return "the mass matrix is not positive definite at this posture: a joint moves no mass";
    case Status::NotNormalized:
      return "a quaternion or a (cos, sin) pair in q is not of unit length: normalise it";
    case Status::NotPhysical:
      return "a mass distribution is none that a solid has: inertia_problem() says what is wrong";
    case Status::NotFinite:
      return "an input holds a NaN or an infinity, or is so large that the result does";
    case Status::WrongSize:
      return "an argument has the wrong number of entries";
    case Status::NotEvaluated:
      return "derivatives were asked for that do not belong to the last evaluation: evaluate "
             "first, "
             "then differentiate, with no other evaluation or change of contacts between";
  }
  return "unknown status";
}

}  // namespace burnish
