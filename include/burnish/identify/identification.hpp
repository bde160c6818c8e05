// Estimates the mass distributions of chosen bodies, or of a payload, from a recorded motion. Each
// estimate has a standard deviation.
//
// Positions and torques are smoothed and differentiated by local polynomials over the same short
// windows (A. Savitzky, M. Golay, 1964). The polynomials are symmetric in time, so that they delay
// neither positions nor torques.
//
// Torques are linear in the mass parameters (ContactDynamics::regressor). They stay linear if both
// sides of the equation are smoothed over longer windows. This smoothing reduces the noise and adds
// no bias.
//
// Mass distributions are estimated in log-Cholesky coordinates (C. Rucker, P. Wensing, "Smooth
// Parameterization of Rigid-Body Inertia", 2022). Every value of these coordinates is a physically
// possible body. docs/identification.md has the equations.
#pragma once

#include <string>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/model/inertia.hpp"

namespace burnish {

/// A measured motion: positions and torques, one row per sample.
struct MotionRecord {
  /// Time between samples [s]
  double period = 1e-3;
  /// Positions [rad or m], n x nq. A continuous joint may have one angle in place of (cos, sin).
  RowMatrix q;
  RowMatrix tau;            ///< Torques [Nm or N], n x nv
  double first_time = 0.0;  ///< Time of the first sample [s], used in messages
  /// Warnings about corrected sample times, one sentence each
  std::vector<std::string> warnings = {};
};

/// Returns positions and torques of a trace. A run of ClosedLoop has the columns
/// `measured_q_<name>` and `tau_measured_<name>`. If such a column is missing, the column
/// `q_<name>` or `tau_<name>` is used. A continuous joint has the column `q_<joint>` (angle [rad],
/// wrapped or not), or the columns `q_<joint>.cos` and `q_<joint>.sin`. If the trace has both
/// forms, cos and sin are used.
///
/// Uneven sample times (by more than 1 %) and lost samples are corrected by resampling, with a
/// warning. Throws Error for
/// - a missing column,
/// - times that do not increase,
/// - a gap that is longer than 30 ms and longer than three periods,
/// - more than 5 % of lost samples.
MotionRecord motion_record(const Model& model, const Trace& trace);

struct IdentificationSpec {
  /// Links whose mass distributions are estimated; empty: the payload is estimated
  std::vector<std::string> bodies = {};
  /// Frame in which the payload's mass distribution is expressed. It is used if `bodies` is empty.
  std::string payload = "tool";
  /// Whether to estimate Coulomb and viscous friction of each entry of v. Use this for motor
  /// torques; sensors behind the gears do not measure this friction.
  bool friction = false;
  /// Whether to estimate the armature of each joint (rotor inertia behind the gear). The estimate
  /// replaces the model's armature. Use this for motor torques.
  bool armature = false;
  /// Whether to estimate a constant offset of each torque
  bool offset = false;
  /// Whether to estimate the delay of torques relative to positions
  bool delay = true;
  /// Window of the polynomials that differentiate the motion, at least seven samples [s]. It must
  /// be short compared with the period of the fastest motion.
  double motion_window = 0.04;
  /// Window for the smoothing of measured and modelled torques [s]
  double window = 0.25;
  /// Duration at the start of the record that is not used [s]
  double start = 0.0;
  /// Standard deviation of the noise of a torque sample [Nm or N]; 0: estimated from neighbouring
  /// samples. The test of torque residuals uses this noise.
  double torque_noise = 0.0;
};

/// An estimated value and its standard deviation.
struct Estimate {
  double value = 0.0, sigma = 0.0;
};

/// Estimated mass distribution of a link or of the payload.
struct EstimatedInertia {
  /// Name of the link or of the payload's frame. All values are in the axes of this frame.
  std::string frame;
  /// Estimated mass distribution; always physically possible
  InertiaSpec inertia;
  /// Ten entries of `inertia`: mass [kg], com [m], and the moments of inertia xx, xy, xz, yy, yz,
  /// zz about com [kg m^2].
  Vector10 values = Vector10::Zero();
  Vector10 sigma = Vector10::Zero();
  /// Prior standard deviation of each entry of `values`. If `sigma` of an entry is nearly as large,
  /// the motion does not determine the entry, and the estimate is mostly the prior value.
  Vector10 prior_sigma = Vector10::Zero();
  /// Returns whether the motion determines entry i of `values`: sigma[i] is less than half of
  /// prior_sigma[i].
  bool is_shown(int i) const { return sigma[i] < 0.5 * prior_sigma[i]; }
  /// Returns the indices of the entries of `values` that the motion does not determine.
  std::vector<int> not_shown() const;
};
/// Returns mass, com and moments of inertia about com, in the order of EstimatedInertia::values.
Vector10 estimate_values(const InertiaSpec& inertia);
/// Names of the entries of EstimatedInertia::values.
inline constexpr std::array<std::string_view, 10> estimate_names{
    "mass", "com x", "com y", "com z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};

struct Identification {
  std::vector<EstimatedInertia> inertias;
  /// Estimates for each entry of v: viscous friction [Nms/rad or Ns/m], Coulomb friction [Nm or N],
  /// rotor inertia [kg m^2 or kg], torque offset [Nm or N]. A list is empty if its estimate was not
  /// requested.
  std::vector<Estimate> viscous, coulomb, armature, offset;
  /// Delay of torques relative to positions [s]
  Estimate delay;
  /// RMS torque residual of the model as given, for each entry of v (nv entries) [Nm or N]
  Eigen::VectorXd rms_before;
  /// RMS torque residual after the estimation, for each entry of v (nv entries) [Nm or N]
  Eigen::VectorXd rms_after;
  /// Expected RMS torque residual, for each entry of v (nv entries) [Nm or N]. It is computed from
  /// noise of torques and positions, smoothing and sampling.
  Eigen::VectorXd rms_expected;
  int samples = 0;  ///< Number of samples that were used, per torque
  bool converged = false;
  std::vector<std::string> warnings;  ///< Warnings, one sentence each
};

/// Estimates mass distributions from a motion without contact. The record is checked first. Wrapped
/// angles and single outliers are corrected, with a warning.
///
/// Throws Error, with a message of one sentence, for
/// - unknown names, and links that are fixed to each other,
/// - a floating base or a joint of several entries, because encoders do not measure their motion,
/// - a record of the wrong size, with a NaN, or shorter than ten windows,
/// - an arm at rest, jumps of positions, stuck encoders, and torques that never change (the message
///   names column, time and a likely cause),
/// - a torque residual that noise does not explain, if a fault of the record explains it far
///   better, or if nothing explains it,
/// - a motion that does not determine the parameters.
///
/// Faults that are considered: units, signs, swapped columns, a lag, gravity, an encoder's offset,
/// a payload that changes.
///
/// If a residual is too large for noise, but small compared with the effect of the masses, the
/// standard deviations are enlarged and a warning is added.
Identification identify(const Model& model, const MotionRecord& record,
                        const IdentificationSpec& spec = {});

}  // namespace burnish
