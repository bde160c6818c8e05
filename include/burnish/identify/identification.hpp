// Mass distributions from a recorded motion: those of chosen bodies, or of what a robot carries,
// with their uncertainty.
//
// Positions and torques are differentiated by the same short local polynomials (A. Savitzky, M.
// Golay, 1964), forwards and backwards alike, so that neither is late; with that motion the torques
// are linear in the masses (ContactDynamics::regressor), and remain so when both sides are smoothed
// over longer windows, which take the noise away and nothing from the truth. Masses are estimated
// in log-Cholesky coordinates (C. Rucker, P. Wensing, "Smooth Parameterization of Rigid-Body
// Inertia", 2022), in which every value is a body that there can be. docs/identification.md has the
// equations.
#pragma once

#include <string>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/model/inertia.hpp"

namespace burnish {

/// A motion as it was measured, a row per sample.
struct MotionRecord {
  double period = 1e-3;  ///< s between samples
  /// n x nq, or with one angle for each continuous joint in place of (cos, sin) [rad, m]
  RowMatrix q;
  RowMatrix tau;                           ///< n x nv: Nm, N
  double first_time = 0.0;                 ///< of the first sample, for sentences [s]
  std::vector<std::string> warnings = {};  ///< sentences about what was mended in the times
};

/// The columns `measured_q_<name>` and `tau_measured_<name>` of a run's trace (ClosedLoop), or q_
/// and tau_ where it has none of these. A continuous joint has its angle as `q_<joint>` [rad],
/// wrapped or not, or `q_<joint>.cos` and `q_<joint>.sin`; where both are there, these. Throws
/// Error where one is missing and for times that do not increase. Times that are uneven by more
/// than 1 % and single lost samples are resampled, which a warning says; gaps over 30 ms and 5 % of
/// lost samples are refused.
MotionRecord motion_record(const Model& model, const Trace& trace);

struct IdentificationSpec {
  /// Links whose own mass distributions are estimated; empty: those of what the robot carries.
  std::vector<std::string> bodies = {};
  /// Frame that what the robot carries is written in, where no bodies are named.
  std::string payload = "tool";
  /// Joint friction: Coulomb's and viscous of each entry of v. For torques that motors give;
  /// sensors behind the gears do not feel it.
  bool friction = false;
  /// Inertia of each joint's rotor behind its gear, in place of the model's armature. For torques
  /// that motors give, too.
  bool armature = false;
  bool offset = false;  ///< a constant error of each torque
  bool delay = true;    ///< of torques behind positions
  /// s that polynomials span which differentiate the motion, or seven samples: short beside its
  /// fastest part
  double motion_window = 0.04;
  /// s that torques, and what they are compared with, are smoothed over: against noise
  double window = 0.25;
  double start = 0.0;  ///< s at the start of the record that are left out
  /// Standard deviation of each torque sample's noise, that the residuals are tested against [Nm,
  /// N]; 0: estimated from neighbouring samples
  double torque_noise = 0.0;
};

/// A number with its standard deviation.
struct Estimate {
  double value = 0.0, sigma = 0.0;
};

/// One of the mass distributions that were asked for.
struct EstimatedInertia {
  std::string frame;    ///< the link, or the payload's frame; all is in its axes
  InertiaSpec inertia;  ///< as estimated: a solid has it
  /// of `inertia`: mass (kg), com (m), then xx xy xz yy yz zz about com (kg m^2)
  Vector10 values = Vector10::Zero();
  Vector10 sigma = Vector10::Zero();
  /// The standard deviation before the motion was seen. What the motion does not show has nearly
  /// this one still, and its value is little but what was believed before.
  Vector10 prior_sigma = Vector10::Zero();
  /// Whether the motion shows entry i of values: it halved the standard deviation at least.
  bool is_shown(int i) const { return sigma[i] < 0.5 * prior_sigma[i]; }
  /// Numbers of the entries that it does not show.
  std::vector<int> not_shown() const;
};
/// mass, com and moments about com, as EstimatedInertia::values has them.
Vector10 estimate_values(const InertiaSpec& inertia);
/// Names of those entries.
inline constexpr std::array<std::string_view, 10> estimate_names{
    "mass", "com x", "com y", "com z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};

struct Identification {
  std::vector<EstimatedInertia> inertias;
  /// nv each where they were asked for, else empty: Nms/rad (Ns/m), Nm (N), kg m^2 (kg), Nm (N).
  std::vector<Estimate> viscous, coulomb, armature, offset;
  Estimate delay;              ///< s
  Eigen::VectorXd rms_before;  ///< nv, of the torques that the model as given leaves, Nm (N)
  Eigen::VectorXd rms_after;   ///< nv, of those that what was found leaves
  /// nv, of those that noise of torques and positions, smoothing and sampling explain
  Eigen::VectorXd rms_expected;
  int samples = 0;  ///< that were used, of each torque
  bool converged = false;
  std::vector<std::string> warnings;  ///< sentences
};

/// Estimates them from a motion without contact. Throws Error with one sentence for names that the
/// robot does not know, a floating base and joints of several entries (whose motion encoders do not
/// tell), records of other sizes or with a NaN, and records that are shorter than ten windows.
///
/// The record is judged, too. Wrapped angles and single outliers are mended with a warning. Throws
/// Error, naming column, time and guess, for an arm at rest, jumps, stuck encoders and torques that
/// never change; and where the residual exceeds what noise explains and a fault of the record
/// (units, signs, swapped columns, a lag, gravity, an encoder's offset, a payload that changes)
/// explains it far better, or nothing does. A residual that is too large for noise and yet small
/// beside what the masses do is a warning, and enlarges the standard deviations.
Identification identify(const Model& model, const MotionRecord& record,
                        const IdentificationSpec& spec = {});

}  // namespace burnish
