#include "burnish/base/status.hpp"

namespace burnish {

std::string_view describe(Status status) {
  switch (status) {
    case Status::Ok:
      return "ok";
    case Status::NotConverged:
      return "the proximal iterations stopped before they reached their tolerance: allow more "
             "iterations or lower mu; neither helps if contact rows contradict each other";
    case Status::SingularContacts:
      return "the contacts are redundant or cannot be held by the joints at this posture: call "
             "diagnose() for the names of these contacts, or set mu > 0";
    case Status::SingularMass:
      return "the mass matrix is not positive definite at this posture: a joint moves no mass";
    case Status::NotNormalized:
      return "a quaternion or a (cos, sin) pair in q is not of unit length: normalise it";
    case Status::NotPhysical:
      return "no solid can have this mass distribution: inertia_problem() returns the reason";
    case Status::NotFinite:
      return "an input has a NaN or an infinity, or is so large that the result overflows";
    case Status::WrongSize:
      return "an argument has the wrong number of entries";
    case Status::NotEvaluated:
      return "the requested derivatives do not belong to the last evaluation: evaluate, then "
             "differentiate, without another evaluation or a change of contacts in between";
  }
  return "unknown status";
}

}  // namespace burnish
