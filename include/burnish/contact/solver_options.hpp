// How the contact system is solved.
#pragma once

namespace burnish {

/// A row of a contact counts as held where more than this part of what could have been moves along
/// it that the rows before it do not hold: angles of a file with six decimals are right to 5e-7.
inline constexpr double independence_tolerance = 1e-6;

/// The KKT system of eq. (3) and its relaxation.
struct ContactSolver {
  /// Compliance, the lower right block -mu 1 of the KKT matrix. 0: the exact system, which needs
  /// independent rows. Positive: any rows, m/s^2 per unit force.
  double mu = 0.0;
  /// With mu > 0: refinements lambda <- G^-1 (rho + mu lambda), at most; they remove the compliance
  /// while it lasts. 0 keeps the compliant solution.
  int max_proximal_iterations = 0;
  /// The iterations stop when every |mu (lambda - previous)| <= this, m/s^2: what is left of the
  /// contact acceleration.
  double proximal_tolerance = 1e-9;

  /// Throws Error with a sentence naming the option that is negative or not finite.
  void check() const;
};

}  // namespace burnish
