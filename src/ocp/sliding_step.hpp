// Effect of friction on a sliding tool in one explicit step of a stage.
#pragma once

#include <optional>

#include "burnish/ocp/problem_spec.hpp"

namespace burnish::ocp {

/// Friction on the tool of a contact in one step.
struct SlidingStep {
  double coefficient = 0.0;
  double force = 0.0;  ///< Force along the normal [N]
  double mass = 0.0;   ///< Smallest apparent mass of the tool perpendicular to the normal [kg]
  double step = 0.0;   ///< Step [s]

  /// Returns the speed that friction removes from the tool in one step [m/s]. If the fade speed of
  /// friction is smaller than this speed, a step can reverse the sliding. With a fade speed below
  /// half this speed, semi-implicit steps make the tool oscillate with growing amplitude.
  double speed() const { return coefficient * force * step / mass; }
};

/// Returns the longest explicit step of a stage's knots [s]; 0 for impacts. A knot longer than the
/// stage's step counts as one stage step, because KnotTime::step_ratio reduces its contact gains.
double explicit_step(const ProblemSpec& spec, const Stage& stage);

/// Returns the effect of a contact's friction in a stage with this contact, at the initial posture.
/// Returns nothing if the contacts cannot be evaluated at this posture, or if no joint moves the
/// tool perpendicular to the normal. Throws Error like ContactDynamics.
std::optional<SlidingStep> sliding_step(const ProblemSpec& spec, const Stage& stage,
                                        const ContactSpec& contact);

}  // namespace burnish::ocp
