// Friction of a sliding tool against the explicit step of a stage.
#pragma once

#include <optional>

#include "burnish/ocp/problem_spec.hpp"

namespace burnish::ocp {

/// What friction does to the tool of a contact in one step.
struct SlidingStep {
  double coefficient = 0.0;
  double force = 0.0;  ///< N, along the normal
  double mass = 0.0;   ///< kg, the least that the tool moves with across the normal
  double step = 0.0;   ///< s

  /// Speed that friction takes from the tool, m/s. Friction that fades below less overshoots rest
  /// within the step; below half of it semi-implicit steps swing ever further.
  double speed() const { return coefficient * force * step / mass; }
};

/// The longest explicit step of a stage, s: of its knots, where those that are longer than the
/// stage's count as that, since numerical gains are slowed down there; zero for impacts.
double explicit_step(const ProblemSpec& spec, const Stage& stage);

/// Of a contact with friction in a stage that holds it; empty where the contacts cannot be
/// evaluated at the initial state. Throws Error as ContactDynamics does.
std::optional<SlidingStep> sliding_step(const ProblemSpec& spec, const Stage& stage,
                                        const ContactSpec& contact);

}  // namespace burnish::ocp
