// Stability margins of a controller: the extra command delay and the error of one joint's torque
// that it tolerates. They come from the sampled loop around an arm, linearised at rest, before a
// run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// What lies between a controller and the joints, and what its tool presses on. A zero switches the
/// delay, lag or filter off.
struct LoopChain {
  double command_delay = 0.0;       ///< From the controller to the motors [s].
  double torque_cutoff = 0.0;       ///< First-order lag of the motors [rad/s].
  bool difference_velocity = true;  ///< Velocities are differences of measured positions.
  double velocity_cutoff = 0.0;     ///< Low-pass of those differences [rad/s].
  double force_cutoff = 0.0;        ///< Low-pass of the measured force [rad/s].
  double stiffness = 1e5;           ///< Of the surface, along its normal [N/m].
  double damping = 500.0;           ///< Of the surface, along its normal [Ns/m].
};

/// Factors by which the torque of one joint may be wrong while the others are right: 0.1 to 10 were
/// tried.
/// @described mpc @result
struct GainRange {
  std::string joint;
  double below = 0.0;  ///< smallest factor
  double above = 0.0;  ///< largest factor
};

/// Stability margins of a controller's loop around an arm.
/// @described mpc @result
struct LoopMargins {
  /// [s], largest extra command delay at which the loop is stable, up to 0.01; 0: it is unstable
  /// without any
  double delay = 0.0;
  double bandwidth = 0.0;  ///< [rad/s] of the model-error observer for which that delay is smallest
  std::vector<GainRange> gains = {};  ///< one range per entry of v
};

/// The linearised loop of one phase of a schedule, at rest in the specification's initial state.
/// It contains mass matrix, gravity, surface, motors, filters, delays as shift registers, the first
/// gains of the plan, the model-error observer of kind torque and its force gain. It leaves out
/// friction, noise, limits and all other estimators. Margins are the worst over three observer
/// bandwidths: the lowest (calm), the nominal one, and halfway from there to the boosted one. A
/// loop counts as stable while growth() is below 8/s.
class LoopAnalysis {
 public:
  static constexpr double longest_delay = 0.01;  ///< [s]
  static constexpr double largest_gain = 10.0;
  static constexpr double smallest_gain = 0.1;

  /// Solves the problem of `phase`, an index of `spec.schedule`, and differentiates its first
  /// control. Throws Error for a base that floats, a robot with loops, supports, and as
  /// MpcController does.
  LoopAnalysis(const MpcSpec& spec, const LoopChain& chain, int phase);
  ~LoopAnalysis();
  LoopAnalysis(LoopAnalysis&&) noexcept;
  LoopAnalysis& operator=(LoopAnalysis&&) noexcept;

  /// Rate at which the fastest disturbance grows [1/s], with the observer at `bandwidth` [rad/s]
  /// and commands `extra_delay` later [s].
  double growth(double bandwidth, double extra_delay) const;
  /// Whether the loop is stable with an extra delay [s] and, tested separately, with the torque of
  /// any one joint scaled by `factor` or 1 / `factor`. `options` take the place of the
  /// specification's model_error.
  bool tolerates(const ModelErrorOptions& options, double delay, double factor) const;
  /// Margins without the ranges of gains, which take longest.
  LoopMargins delay_margin(const ModelErrorOptions& options) const;
  /// Delay and ranges of gains.
  LoopMargins margins(const ModelErrorOptions& options) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reason why margins cannot be computed for a specification, one sentence; empty if they can.
std::string without_margins(const MpcSpec& spec);

/// Index of the first phase in which the tool has no contact (free_phase) and of the last phase in
/// which it has one (pressing_phase); -1 if there is no such phase.
int free_phase(const MpcSpec& spec);
int pressing_phase(const MpcSpec& spec);

}  // namespace burnish
