// Stability margins of an arm's controller, computed before a run from the closed loop linearized
// at rest. One margin is the largest extra delay of commands at which the loop is stable. The other
// margins are the stable ranges of a factor on the torque of each joint.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/mpc/loop_chain.hpp"
#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Stable range of a factor on the torque of one joint. The control loop is stable for factors in
/// this range if the torques of all other joints are exact. Only factors from 0.1 to 10 are tried.
/// @described mpc @result
struct GainRange {
  std::string joint;
  double below = 0.0;  ///< Smallest torque factor at which the control loop is stable
  double above = 0.0;  ///< Largest torque factor at which the control loop is stable
};

/// Stability margins of the closed loop of a controller and an arm.
/// @described mpc @result
struct LoopMargins {
  /// Largest extra delay of commands at which the control loop is stable [s]
  /// @more Delays up to 0.01 s are tried. The value 0 means that the control loop is unstable even
  /// without extra delay
  double delay = 0.0;
  /// Bandwidth of the model-error observer for which the delay margin is smallest [rad/s]
  /// @more The delay margin is computed for up to three bandwidths
  double bandwidth = 0.0;
  std::vector<GainRange> gains = {};  ///< Stable ranges of torque factors, one per entry of v
};

/// Closed loop of a controller and an arm in one phase of a schedule. The loop is linearized at
/// rest in the specification's initial state. The model of the loop contains the mass matrix,
/// gravity, surface, motors, filters, delays (as shift registers), the plan's gains at knot 0, the
/// observer of torque errors, and the force gain from ModelErrorOptions. Friction, noise, limits
/// and other estimators are left out.
///
/// Each margin is the smallest over up to three bandwidths of the observer: the nominal bandwidth,
/// `quiescent_scale` times the nominal bandwidth, and the midpoint between the nominal bandwidth
/// and `transient_scale` times the nominal bandwidth. The loop counts as stable if growth() is
/// below 8/s.
class LoopAnalysis {
 public:
  static constexpr double max_delay = 0.01;  ///< Largest extra delay that is tried [s]
  static constexpr double largest_gain = 10.0;
  static constexpr double smallest_gain = 0.1;

  /// Solves the optimal control problem at the start of the phase with the index `phase` in
  /// `spec.schedule`. Then computes how the first control of the plan depends on the initial state
  /// and on the torque error. Throws Error if without_margins() returns a reason, such as a
  /// floating base, kinematic loops or supports. Also throws Error in the same cases as
  /// MpcController.
  LoopAnalysis(const MpcSpec& spec, const LoopChain& chain, int phase);
  ~LoopAnalysis();
  LoopAnalysis(LoopAnalysis&&) noexcept;
  LoopAnalysis& operator=(LoopAnalysis&&) noexcept;

  /// Returns the growth rate of the fastest-growing deviation from rest [1/s]. `bandwidth`:
  /// bandwidth of the model-error observer [rad/s]. `extra_delay`: added delay of commands [s].
  double growth(double bandwidth, double extra_delay) const;
  /// Returns true if the loop is stable in two separate tests. In the first test, commands have the
  /// extra delay `delay` [s]. In the second test, the torque of any one joint is multiplied by
  /// `factor` or by 1 / `factor`. `options` are used instead of MpcSpec::model_error.
  bool tolerates(const ModelErrorOptions& options, double delay, double factor) const;
  /// Returns the delay margin. LoopMargins::gains stays empty, which saves computing time.
  LoopMargins delay_margin(const ModelErrorOptions& options) const;
  /// Returns the delay margin and the ranges of torque factors.
  LoopMargins margins(const ModelErrorOptions& options) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the reason why margins cannot be computed for `spec`, as one sentence. The sentence is
/// empty if margins can be computed.
std::string without_margins(const MpcSpec& spec);

/// Returns the index of the first phase without contact at the tool; -1: every phase has contact.
int free_phase(const MpcSpec& spec);
/// Returns the index of the last phase with contact at the tool; -1: no phase has contact.
int pressing_phase(const MpcSpec& spec);

}  // namespace burnish
