// Estimates the mass distributions of chosen bodies, or of a payload, from a recorded motion. Each
// estimate has a standard deviation.
//
// Positions and torques are smoothed and differentiated by local polynomials (A. Savitzky, M.
// Golay, 1964). All windows of this step have the same short length. The polynomials are symmetric
// in time, so that they delay neither positions nor torques.
//
// Torques are linear in the mass parameters (ContactDynamics::regressor). They stay linear if
// measured and modelled torques are smoothed in the same way. Both torques are therefore smoothed
// again over longer windows, which reduces the noise and adds no bias.
//
// Mass distributions are estimated in log-Cholesky coordinates (C. Rucker, P. Wensing, "Smooth
// Parameterization of Rigid-Body Inertia", 2022). Every value of these coordinates describes a
// physically possible body. docs/identification.md has the equations.
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
  /// Positions [rad or m], one row per sample, nq columns. A continuous joint may have one angle in
  /// place of (cos, sin).
  RowMatrix q;
  RowMatrix tau;            ///< Torques [Nm or N], one row per sample, nv columns
  double first_time = 0.0;  ///< Time of the first sample [s], used in messages
  /// Warnings about corrected sample times, one sentence each
  std::vector<std::string> warnings = {};
};

/// Reads positions and torques from a trace. A trace of ClosedLoop has the columns
/// `measured_q_<name>` and `tau_measured_<name>`. If one of these columns is missing, `q_<name>` or
/// `tau_<name>` is used. A continuous joint has the column `q_<joint>` (angle [rad], wrapped or
/// not), or the columns `q_<joint>.cos` and `q_<joint>.sin`. If a trace has the angle and also cos
/// and sin, cos and sin are used.
///
/// Sample times that are uneven by more than 1 %, and lost samples, are corrected by resampling,
/// with a warning. Throws Error for
/// - a missing column,
/// - times that do not increase,
/// - a gap that is longer than 30 ms and longer than three periods,
/// - more than 5 % of lost samples.
MotionRecord motion_record(const Model& model, const Trace& trace);

struct IdentificationSpec {
  /// Links whose mass distributions are estimated; empty: the payload is estimated
  std::vector<std::string> bodies = {};
  /// Name of the frame that carries the payload. The estimate is in the axes of this frame. Used
  /// only if `bodies` is empty.
  std::string payload = "tool";
  /// Whether to estimate Coulomb and viscous friction for each entry of v. Useful if torques are
  /// measured at the motors. Torque sensors behind the gears do not measure this friction.
  bool friction = false;
  /// Whether to estimate the armature of each joint (rotor inertia behind the gear). The estimate
  /// replaces the model's armature. Useful if torques are measured at the motors.
  bool armature = false;
  /// Whether to estimate a constant offset of each torque
  bool offset = false;
  /// Whether to estimate the delay of torques relative to positions
  bool delay = true;
  /// Window length of the polynomials that differentiate the motion [s]. The window must have at
  /// least seven samples. It must be short compared with the period of the fastest motion.
  double motion_window = 0.04;
  /// Window length for the smoothing of measured and modelled torques [s]
  double window = 0.25;
  /// Length of the unused part at the start of the record [s]
  double start = 0.0;
  /// Standard deviation of the noise of a torque sample [Nm or N], for the test of torque
  /// residuals. At 0, the noise is estimated from neighbouring samples.
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
  /// Prior standard deviation of each entry of `values`. If `sigma` is nearly as large as this
  /// prior, the motion does not determine the entry. The estimate is then mostly the prior value.
  Vector10 prior_sigma = Vector10::Zero();
  /// Returns whether the motion determines entry i of `values`: sigma[i] is less than half of
  /// prior_sigma[i].
  bool is_shown(int i) const { return sigma[i] < 0.5 * prior_sigma[i]; }
  /// Returns the indices of the entries of `values` that the motion does not determine.
  std::vector<int> not_shown() const;
};
/// Returns the mass, the centre of mass, and the moments of inertia about the centre of mass, in
/// the order of EstimatedInertia::values.
Vector10 estimate_values(const InertiaSpec& inertia);
/// Names of the entries of EstimatedInertia::values.
inline constexpr std::array<std::string_view, 10> estimate_names{
    "mass", "com x", "com y", "com z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};

struct Identification {
  std::vector<EstimatedInertia> inertias;
  /// Estimates for each entry of v: viscous friction [Nms/rad or Ns/m], Coulomb friction [Nm or N],
  /// rotor inertia [kg m^2 or kg], torque offset [Nm or N]. A list that was not requested is empty.
  std::vector<Estimate> viscous, coulomb, armature, offset;
  /// Delay of torques relative to positions [s]
  Estimate delay;
  /// RMS torque residual of the model before the estimation, for each entry of v (nv entries) [Nm
  /// or N]
  Eigen::VectorXd rms_before;
  /// RMS torque residual of the model after the estimation, for each entry of v (nv entries) [Nm or
  /// N]
  Eigen::VectorXd rms_after;
  /// Expected RMS torque residual, for each entry of v (nv entries) [Nm or N]. It is computed from
  /// the noise of torques and positions, the smoothing and the sampling.
  Eigen::VectorXd rms_expected;
  int samples = 0;  ///< Number of samples that were used for each torque
  bool converged = false;
  std::vector<std::string> warnings;  ///< Warnings, one sentence each
};

/// Estimates mass distributions from a motion without contact. First checks the record. Wrapped
/// angles and single outliers in the record are corrected, with a warning.
///
/// Throws Error, with a message of one sentence, for
/// - unknown names, and links that are fixed to each other,
/// - a floating base or a joint with several degrees of freedom, since encoders do not measure
///   their motion,
/// - a record of the wrong size, with a NaN, or shorter than ten windows,
/// - an arm at rest, jumps of positions, stuck encoders, and torques that never change (the message
///   names column, time and a likely cause),
/// - a torque residual that noise does not explain, if a fault of the record explains the residual
///   far better, or if no cause is found,
/// - a motion that does not determine the parameters.
///
/// The considered faults of the record are wrong units, wrong signs, swapped columns, a lag, wrong
/// gravity, an encoder's offset, and a payload that changes.
///
/// A torque residual can be too large for noise and yet small compared with the effect of the
/// masses. In this case, the standard deviations are enlarged and a warning is added.
Identification identify(const Model& model, const MotionRecord& record,
                        const IdentificationSpec& spec = {});

}  // namespace burnish
