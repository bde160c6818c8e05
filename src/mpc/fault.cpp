#include "burnish/mpc/fault.hpp"

#include <cstdio>

namespace burnish {

std::string_view name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::None:
      return "no fault";
    case FaultKind::StaleMeasurement:
      return "stale measurement";
    case FaultKind::BadMeasurement:
      return "bad measurement";
    case FaultKind::OutOfRange:
      return "joint out of range";
    case FaultKind::SolverFailed:
      return "solver failed";
    case FaultKind::SolverLate:
      return "solver late";
    case FaultKind::ContactLost:
      return "contact lost";
    case FaultKind::NoContact:
      return "no contact";
    case FaultKind::ContactLate:
      return "contact late";
    case FaultKind::UnexpectedContact:
      return "unexpected contact";
    case FaultKind::ForceLimit:
      return "force limit";
    case FaultKind::SpeedLimit:
      return "speed limit";
    case FaultKind::SupportSlipped:
      return "support slipped";
    case FaultKind::MotorLost:
      return "motor lost";
    case FaultKind::Watched:
      return "beyond a limit";
    case FaultKind::BaseLost:
      return "base lost";
  }
  return "no fault";
}

namespace {
/// What value and limit of a fault are.
const char* words(FaultKind kind) {
  switch (kind) {
    case FaultKind::StaleMeasurement:
      return "%s at %.4f s: no new measurement for %.4g s; allowed are %.4g s";
    case FaultKind::BadMeasurement:
      return "%s at %.4f s: not a state for %.4g s; allowed are %.4g s";
    case FaultKind::OutOfRange:
      return "%s at %.4f s: position %.4g; the limit is %.4g";
    case FaultKind::SolverFailed:
      return "%s at %.4f s: no usable plan for %.0f updates in a row; the limit is %.0f";
    case FaultKind::SolverLate:
      return "%s at %.4f s: %.0f updates in a row past their deadline; the limit is %.0f";
    case FaultKind::ContactLost:
      return "%s at %.4f s: no force for %.4g s while it was wanted; allowed are %.4g s";
    case FaultKind::NoContact:
      return "%s at %.4f s: the tool went on %.4g m without a force after contact was due; allowed "
             "are %.4g m";
    case FaultKind::ContactLate:
      return "%s at %.4f s: no force for %.4g s after contact was due; allowed are %.4g s";
    case FaultKind::UnexpectedContact:
      return "%s at %.4f s: %.4g N while no contact was wanted; allowed are %.4g N";
    case FaultKind::ForceLimit:
      return "%s at %.4f s: %.4g N at the tool; allowed are %.4g N";
    case FaultKind::SpeedLimit:
      return "%s at %.4f s: a speed of %.4g; allowed is %.4g";
    case FaultKind::SupportSlipped:
      return "%s at %.4f s: %.4g m away from where it was; allowed are %.4g m";
    case FaultKind::MotorLost:
      return "%s at %.4f s: a torque of %.4g Nm (N) off what was sent; allowed are %.4g";
    case FaultKind::Watched:
      return "%s at %.4f s: %.4g; allowed is %.4g";
    case FaultKind::BaseLost:
      return "%s at %.4f s: nothing told where the base is for %.4g s; allowed are %.4g s";
    case FaultKind::None:
      break;
  }
  return "%s";
}
}  // namespace

std::string FaultReport::text() const {
  char buffer[256];
  // The format is one of those above.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
  std::snprintf(buffer, sizeof buffer, words(kind), std::string(name_of(kind)).c_str(), time, value,
                limit);
#pragma GCC diagnostic pop
  std::string sentence = buffer;
  if (!quantity.empty()) sentence += " (" + quantity + ")";
  if (joint >= 0) sentence += " (entry " + std::to_string(joint) + " of v)";
  return sentence;
}

}  // namespace burnish
