// What a numerical evaluation answers instead of a NaN or an exception.
#pragma once

#include <cstdint>
#include <string_view>

namespace burnish {

/// One that nobody looks at is a warning of the compiler.
enum class [[nodiscard]] Status : std::uint8_t;

/// Outcome of an evaluation, ordered by severity: of two that apply the larger is reported.
enum class Status : std::uint8_t {
  Ok = 0,
  NotConverged,      ///< proximal iterations stopped at their limit above the tolerance
  SingularContacts,  ///< contact rows are redundant or not controllable, and mu = 0
  SingularMass,      ///< the mass matrix is not positive definite at this posture
  NotNormalized,     ///< a quaternion or a (cos, sin) pair is not of unit length to 1e-6
  NotPhysical,       ///< a mass distribution that no solid has
  NotFinite,         ///< an input holds a NaN or an infinity, or is so large that the result does
  WrongSize,         ///< an argument has the wrong number of entries
  NotEvaluated,      ///< derivatives of an evaluation that was not the last one made
};

/// One sentence that says what the status means and what to do about it.
std::string_view describe(Status status);

/// The more severe of the two.
constexpr Status worst(Status a, Status b) { return a < b ? b : a; }

}  // namespace burnish
