// Status codes that numerical evaluations return instead of a NaN or an exception.
#pragma once

#include <cstdint>
#include <string_view>

namespace burnish {

/// Result of an evaluation. Ignoring a returned Status causes a compiler warning.
enum class [[nodiscard]] Status : std::uint8_t;

/// Outcome of an evaluation, ordered by severity. If several outcomes apply, the most severe
/// outcome is returned.
/// @described base
enum class Status : std::uint8_t {
  Ok = 0,
  NotConverged,  ///< Proximal iterations ended at their maximum number, before the tolerance was
                 ///< reached
  SingularContacts,  ///< Contact constraints are redundant or not controllable, and their
                     ///< compliance mu is 0
  SingularMass,      ///< Mass matrix is not positive definite at this configuration
  NotNormalized,     ///< Length of a quaternion or (cos, sin) pair differs from 1 by over 1e-6
  NotPhysical,       ///< Mass distribution that no solid can have
  NotFinite,         ///< Input has a NaN or an infinity, or is so large that the result overflows
  WrongSize,         ///< Argument has the wrong number of entries
  NotEvaluated,      ///< Derivatives were requested without the evaluation that they belong to
};

/// Returns one sentence with the meaning of the status and what to do about it.
std::string_view describe(Status status);

/// Returns whether the evaluation has a result: the status is Ok or NotConverged.
constexpr bool is_usable(Status status) { return status <= Status::NotConverged; }

/// Returns the more severe of two statuses.
constexpr Status worst(Status a, Status b) { return a < b ? b : a; }

}  // namespace burnish
