// Status codes that numerical evaluations return instead of a NaN or an exception.
#pragma once

#include <cstdint>
#include <string_view>

namespace burnish {

/// Result of an evaluation. Ignoring a returned Status causes a compiler warning.
enum class [[nodiscard]] Status : std::uint8_t;

/// Outcome of an evaluation, ordered by severity. If several values apply, the most severe one is
/// returned.
/// @described base
enum class Status : std::uint8_t {
  Ok = 0,
  NotConverged,      ///< Proximal iterations reached their maximum number above the tolerance
  SingularContacts,  ///< Contact rows are redundant or not controllable, and the compliance mu is 0
  SingularMass,      ///< Mass matrix is not positive definite at this posture
  NotNormalized,     ///< Length of a quaternion or (cos, sin) pair differs from 1 by over 1e-6
  NotPhysical,       ///< Mass distribution that no solid can have
  NotFinite,         ///< Input has a NaN or an infinity, or is so large that the result overflows
  WrongSize,         ///< Argument has the wrong number of entries
  NotEvaluated,      ///< Requested derivatives do not belong to the last evaluation
};

/// Returns one sentence with the meaning of the status and what to do about it.
std::string_view describe(Status status);

/// Returns the more severe of two statuses.
constexpr Status worst(Status a, Status b) { return a < b ? b : a; }

}  // namespace burnish
