// Kinematic loops of a robot (Model::loops): contacts that close the loops, redundant directions of
// loops, and projection of postures and velocities onto closed loops.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Baumgarte gains, which correct the drift of a kinematic loop: alpha + kd nu + kp e = 0. The
/// symbols e, nu and alpha are the position error, velocity and acceleration between the loop's two
/// frames.
/// @described contact
/// Source: Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems",
/// 1972. The default gains give critical damping.
struct LoopGains {
  double kp = 1e4;    ///< Gain on the position error [1/s^2], >= 0
  double kd = 200.0;  ///< Gain on the velocity [1/s], >= 0

  /// Returns gains for semi-implicit Euler integration with the time step `step` [s]: kd = 1 / step
  /// and kp = 1 / step^2. With these gains, one time step removes the position error of a loop. For
  /// steps below 1 ms, returns the gains for 1 ms.
  static LoopGains for_step(double step);
};

/// Returns one contact per loop. The contact has the loop's name and keeps the loop closed. Its
/// tool is the loop's second frame, its base is the loop's first frame, and its directions are in
/// the base's axes.
///
/// By default, directions that are redundant at all postures are left out, such as z of a planar
/// mechanism. The remaining rows are independent and need no compliance. A loop without remaining
/// directions gets no contact. If `all_directions` is true, each contact constrains all directions
/// that the model states for the loop.
std::vector<ContactSpec> loop_contacts(const Model& model, const LoopGains& gains = {},
                                       bool all_directions = false);

/// Returns `contacts`, followed by loop_contacts() of all loops whose names do not occur in
/// `contacts`. Throws Error if a contact has the name of a loop but connects other frames.
std::vector<ContactSpec> with_loops(const Model& model, std::vector<ContactSpec> contacts,
                                    const LoopGains& gains = {});

/// Returns whether `contact` has the name and the two frames of a loop of the model.
bool is_loop(const Model& model, const ContactSpec& contact);

/// Redundant directions of a loop. Other constraints of the loops already imply these directions.
/// @described contact @result
struct RedundantLoop {
  std::string loop;
  Directions directions = Directions::linear();
};

/// Degrees of freedom of a robot whose loops are closed.
/// @described contact @result
struct LoopFreedom {
  int rows = 0;                          ///< Number of constraint rows of all loops
  int rank = 0;                          ///< Rank of the Jacobian of all loops
  int freedom = 0;                       ///< Remaining degrees of freedom: nv - rank
  std::vector<RedundantLoop> redundant;  ///< Loops with redundant directions

  /// Returns one line per loop with redundant directions: "four_bar: z, rx, ry redundant".
  std::string text() const;
};
/// Returns the number of loop rows, their rank and the remaining degrees of freedom at the
/// configuration `q` (nq). Throws Error for an invalid q.
LoopFreedom loop_freedom(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// Options for projecting a configuration onto closed loops.
/// @described contact
struct LoopProjectionOptions {
  std::vector<std::string> keep = {};  ///< Names of joints that must not move

  /// Cost of motion for each entry of v: nv positive numbers (empty: equal costs)
  Eigen::VectorXd weights = {};
  /// Largest accepted error of a closed loop in each constrained direction, m or rad, > 0
  double tolerance = 1e-9;
  int max_iterations = 200;  ///< Maximum number of iterations, summed over all restarts, >= 1

  /// Whether revolute and prismatic joints must stay within their position limits @more A joint
  /// that starts beyond a limit does not move further out.
  bool within_limits = true;
};

/// Closure error of a loop.
/// @described contact @result
struct LoopMiss {
  std::string loop;
  /// Length of the position error, in the constrained directions only [m]
  double translation = 0.0;
  /// Size of the rotation error, about the constrained directions only [rad]
  double rotation = 0.0;
};

/// Result of a projection onto the loops. If no posture was found that closes the loops, the result
/// is the posture with the smallest error.
/// @described contact @result
struct LoopProjection {
  Eigen::VectorXd q;             ///< Configuration, nq entries
  std::vector<LoopMiss> misses;  ///< Remaining closure error of each loop
  int iterations = 0;
  Status status = Status::Ok;  ///< NotConverged if a loop is still open

  /// Returns a sentence about the loop with the largest error, such as "loop 'four_bar' cannot be
  /// closed from the given posture: 12 mm remain". Returns an empty text if all loops are closed.
  std::string explanation() const;
};

/// Finds a configuration near `q` (nq) that closes the loops, by damped Gauss-Newton steps on the
/// configuration manifold (eq. (11.5) of docs/theory.md):
///   dq = -W^-1 J^T (J W^-1 J^T + damping)^-1 e.
/// J is the Jacobian of all loop rows, e is the vector of their errors, and W is the diagonal
/// matrix of options.weights. Without damping, dq is the step that removes the linearized error
/// with the smallest dq^T W dq.
///
/// If the steps no longer reduce the error, for example at a dead point, the search restarts from
/// another posture near q. The postures for restarts are the same in every call. Throws Error for
/// an invalid q, options out of range, and unknown joints in `options.keep`.
LoopProjection project_onto_loops(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                  const LoopProjectionOptions& options = {});

/// Returns the closure error of each loop at the configuration `q` (nq). Throws Error for an
/// invalid q.
std::vector<LoopMiss> loop_misses(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// Norm of the change dv of a velocity. A projection onto the loops minimizes this norm.
/// @described contact
enum class LoopMetric {
  Plain,  ///< |dv|^2, with equal weights for rad/s and m/s
  Mass,   ///< dv^T M dv, with the mass matrix M; dv is then the effect of impulses in the loops
};
/// Projects the velocity `v` (nv) onto the loops at `q`: returns the velocity w nearest to `v` with
/// J w = 0 (eq. (11.6) of docs/theory.md). J is the Jacobian of all loop rows.
///
/// Joints named in `keep` keep their velocity if the other joints alone can satisfy J w = 0.
/// Otherwise all joints correct the remaining error. `keep` requires the plain metric. Throws Error
/// for an invalid q or v, unknown joints, `keep` with the mass metric, and a singular mass matrix
/// in the mass metric.
Eigen::VectorXd project_velocity_onto_loops(const Model& model,
                                            const Eigen::Ref<const Eigen::VectorXd>& q,
                                            const Eigen::Ref<const Eigen::VectorXd>& v,
                                            LoopMetric metric = LoopMetric::Plain,
                                            const std::vector<std::string>& keep = {});

/// Returns the configuration of `posture`, corrected so that all loops of the model are closed.
///
/// Joints named in `keep` stay at the values of the posture if the other joints can close the
/// loops. Otherwise all joints may move, which rounded values in a posture often make necessary.
/// The overload without `keep` keeps all joints that the posture names. Throws Error if
/// configuration() rejects the posture, or if the loops cannot be closed (the message states the
/// remaining gap).
Eigen::VectorXd closed_configuration(const Model& model, const Posture& posture);
Eigen::VectorXd closed_configuration(const Model& model, const Posture& posture,
                                     const std::vector<std::string>& keep);

}  // namespace burnish
