// Settings for supports that slip: plans assume less friction at such a support.
#pragma once

namespace burnish {

/// Reaction of plans to a slipping support, such as a foot: plans reduce the coefficient of
/// friction of that support. The reduced coefficient is `friction_fraction` times the measured
/// ratio of tangential to normal force. Without measured forces, the reduced coefficient is
/// `min_friction`. A support counts as slipping if its load (if measured), its sliding speed and
/// its sliding distance within about a second all exceed their thresholds.
/// @described mpc
/// The reduced coefficient applies to the residuals FrictionCone and CenterOfPressure of supports
/// that are in contact in every stage. Supports without a FrictionCone are not affected.
struct SlipOptions {
  /// Reduce the friction coefficient of supports that slip
  bool enabled = true;
  /// Sliding distance above which a support can count as slipping [m], >= 0
  double distance = 2.5e-3;
  /// Sliding speed (mean over 5 ms) above which a support can count as slipping [m/s], >= 0
  double speed = 0.02;
  /// Load above which a support can count as slipping [N], >= 0
  double load = 30.0;
  /// Reduced friction coefficient, as a fraction of the measured ratio of tangential to normal
  /// force of the slipping support, 0 to 1
  double friction_fraction = 0.7;
  /// Lower limit of the reduced friction coefficient, > 0
  double min_friction = 0.02;
  /// Time constant of the reduction of the friction coefficient [s], >= 0
  /// @more Without measured forces, the time constant is doubled. The reduction is gradual, because
  /// the solver would not find a good plan after an abrupt change
  double easing = 0.05;
  /// Rate at which the friction coefficient recovers while the support does not slip [1/s], >= 0
  double recovery = 0.1;
  /// Radius of spherical feet (0: feet are not spherical) [m], >= 0
  /// @more Rolling of a spherical foot does not count as slipping
  double radius = 0.0;
};

}  // namespace burnish
