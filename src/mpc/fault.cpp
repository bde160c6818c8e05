#include "burnish/mpc/fault.hpp"

#include <cstdio>
#include <string>

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

/// Returns the printf format of a fault, for its two numbers (value and limit).
const char* words(FaultKind kind) {
  switch (kind) {
    case FaultKind::StaleMeasurement:
      return "no new measurement for %.4g s; allowed are %.4g s";
    case FaultKind::BadMeasurement:
      return "invalid measurements for %.4g s; allowed are %.4g s";
    case FaultKind::OutOfRange:
      return "position %.4g{unit}; the limit is %.4g{unit}";
    case FaultKind::SolverFailed:
      return "no usable plan for %.0f updates in a row; the limit is %.0f";
    case FaultKind::SolverLate:
      return "%.0f updates in a row past their deadline; the limit is %.0f";
    case FaultKind::ContactLost:
      return "no contact for %.4g s in a phase that requires contact; allowed are %.4g s";
    case FaultKind::NoContact:
      return "the tool moved %.4g m without contact after contact was due; allowed are %.4g m";
    case FaultKind::ContactLate:
      return "no contact for %.4g s after it was due; allowed are %.4g s";
    case FaultKind::UnexpectedContact:
      return "a force of %.4g N in a phase without contact; allowed are %.4g N";
    case FaultKind::ForceLimit:
      return "%.4g N; allowed are %.4g N";
    case FaultKind::SpeedLimit:
      return "%.4g{unit}, allowed %.4g{unit}";
    case FaultKind::SupportSlipped:
      return "slid by %.4g m; allowed are %.4g m";
    case FaultKind::MotorLost:
      return "the torque differs by %.4g{unit} from the command; allowed are %.4g{unit}";
    case FaultKind::Watched:
      return "%.4g; allowed is %.4g";
    case FaultKind::BaseLost:
      return "no estimate of the base for %.4g s; allowed are %.4g s";
    case FaultKind::None:
      break;
  }
  return "";
}

/// Returns the start of a fault's sentence, which names the subject, such as "joint 'elbow': ";
/// empty: no subject.
std::string subject_of(const FaultReport& fault) {
  if (!fault.joint_name.empty()) return "joint '" + fault.joint_name + "': ";
  if (fault.joint >= 0) return "entry " + std::to_string(fault.joint) + " of v: ";
  if (fault.kind == FaultKind::Watched) return "";
  if (fault.kind == FaultKind::SupportSlipped) return "support '" + fault.quantity + "': ";
  if (!fault.quantity.empty()) return fault.quantity + ": ";
  const bool of_tool = fault.kind == FaultKind::SpeedLimit || fault.kind == FaultKind::ForceLimit;
  return of_tool ? "the tool: " : "";
}

}  // namespace

std::string FaultReport::text() const {
  const std::string name(name_of(kind));
  if (kind == FaultKind::None) return name;
  const char* const unit_of_kind = kind == FaultKind::SpeedLimit && joint < 0 ? "m/s" : "";
  const std::string in = unit.empty() ? unit_of_kind : unit;
  std::string format = words(kind);
  for (std::size_t at = 0; (at = format.find("{unit}")) != std::string::npos;)
    format.replace(at, 6, in.empty() ? "" : " " + in);
  char when[64], numbers[256];
  std::snprintf(when, sizeof when, " at %.4f s: ", time);
  // The format is one of the literals in words().
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
  std::snprintf(numbers, sizeof numbers, format.c_str(), value, limit);
#pragma GCC diagnostic pop
  std::string sentence = name + when + subject_of(*this) + numbers;
  if (kind == FaultKind::Watched && !quantity.empty()) sentence += " (" + quantity + ")";
  return cause.empty() ? sentence : sentence + ": " + cause;
}

}  // namespace burnish
