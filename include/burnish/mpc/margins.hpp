// Stability margins of an arm's controller: the largest extra command delay, and the range by which
// one joint's torque may be scaled. They are computed before a run, from the closed loop
// linearized at rest.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Delay, lag and filters between a controller and the joints, and stiffness and damping of the
/// surface. The value 0 switches a delay, lag or filter off.
struct LoopChain {
  double command_delay = 0.0;       ///< Delay from the controller to the motors [s].
  double torque_cutoff = 0.0;       ///< Cutoff of the motors' first-order lag [rad/s].
  bool difference_velocity = true;  ///< True if velocities are differences of measured positions.
  double velocity_cutoff = 0.0;  ///< Cutoff of the low-pass filter of velocity differences [rad/s].
  double force_cutoff = 0.0;     ///< Cutoff of the low-pass filter of the measured force [rad/s].
  double stiffness = 1e5;        ///< Stiffness of the surface along its normal [N/m].
  double damping = 500.0;        ///< Damping of the surface along its normal [Ns/m].
};

/// Range of factors on the torque of one joint within which the loop is stable. The torques of all
/// other joints are exact. Factors from 0.1 to 10 are tried.
/// @described mpc @result
struct GainRange {
  std::string joint;
  double below = 0.0;  ///< Smallest factor at which the loop is stable
  double above = 0.0;  ///< Largest factor at which the loop is stable
};

/// Stability margins of the closed loop of a controller and an arm.
/// @described mpc @result
struct LoopMargins {
  /// Largest extra command delay at which the loop is stable [s]
  /// @more Delays up to 0.01 s are tried. The value 0 means that the loop is unstable even without
  /// extra delay
  double delay = 0.0;
  /// Bandwidth of the model-error observer at which the delay margin is smallest [rad/s]
  double bandwidth = 0.0;
  std::vector<GainRange> gains = {};  ///< Ranges of torque factors, one per entry of v
};

/// Closed loop of a controller and an arm in one phase of a schedule. The loop is linearized at
/// rest in the specification's initial state. It contains the mass matrix, gravity, surface,
/// motors, filters, delays (as shift registers) and the first gains of the plan. It also contains
/// the observer of torque errors and the force gain (ModelErrorOptions). Friction, noise, limits
/// and other estimators are left out.
///
/// Each margin is the smallest over up to three bandwidths of the observer. These are the nominal
/// bandwidth, the bandwidth reduced by `calm`, and the midpoint between the nominal and the boosted
/// one. The loop counts as stable while growth() is below 8/s.
class LoopAnalysis {
 public:
  static constexpr double longest_delay = 0.01;  ///< Largest extra delay that is tried [s]
  static constexpr double largest_gain = 10.0;
  static constexpr double smallest_gain = 0.1;

  /// Solves the optimal control problem at the start of a phase. `phase`: index in `spec.schedule`.
  /// Then computes how the first control depends on the initial state and on the torque error.
  /// Throws Error if without_margins() returns a reason (such as a floating base, loops or
  /// supports), and in the cases in which MpcController throws.
  LoopAnalysis(const MpcSpec& spec, const LoopChain& chain, int phase);
  ~LoopAnalysis();
  LoopAnalysis(LoopAnalysis&&) noexcept;
  LoopAnalysis& operator=(LoopAnalysis&&) noexcept;

  /// Returns the growth rate of the fastest-growing disturbance [1/s]. `bandwidth`: bandwidth of
  /// the observer [rad/s]. `extra_delay`: additional delay of commands [s].
  double growth(double bandwidth, double extra_delay) const;
  /// Returns true if the loop is stable in two separate tests. In the first one, commands have the
  /// extra delay `delay` [s]. In the second one, the torque of any one joint is multiplied by
  /// `factor` or by 1 / `factor`. `options` replace the specification's model_error.
  bool tolerates(const ModelErrorOptions& options, double delay, double factor) const;
  /// Returns the delay margin only. The ranges of torque factors, which take longest to compute,
  /// stay empty.
  LoopMargins delay_margin(const ModelErrorOptions& options) const;
  /// Returns the delay margin and the ranges of torque factors.
  LoopMargins margins(const ModelErrorOptions& options) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the reason why margins cannot be computed for `spec`, as one sentence; empty if they can
/// be computed.
std::string without_margins(const MpcSpec& spec);

/// Returns the index of the first phase without contact at the tool; -1: every phase has contact.
int free_phase(const MpcSpec& spec);
/// Returns the index of the last phase with contact at the tool; -1: no phase has contact.
int pressing_phase(const MpcSpec& spec);

}  // namespace burnish
