// Loops of a robot (Model::loops): the contacts that hold them, which of their rows are
// independent, and postures and velocities that they allow.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// How a loop that has drifted comes back: alpha + kd nu + kp e = 0.
/// @described contact
/// Source: Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems",
/// 1972. The defaults damp critically.
struct LoopGains {
  double kp = 1e4;    ///< [1/s^2], >= 0
  double kd = 200.0;  ///< [1/s], >= 0

  /// For semi-implicit Euler steps of that length, s: kd = 1 / step, kp = 1 / step^2, so that a
  /// step takes away what the loop misses at its start; of steps below 1 ms as for these.
  static LoopGains for_step(double step);
};

/// One contact per loop, called as it: tool is its second frame, base its first, in the axes of the
/// base. Of directions that others imply at all postures (z of a planar mechanism) the contacts
/// leave out as many as are needed for independent rows, so that they can be held without
/// compliance; with `all_directions` they have those of the description.
std::vector<ContactSpec> loop_contacts(const Model& model, const LoopGains& gains = {},
                                       bool all_directions = false);

/// The contacts, and behind them those of loops that are not among them. Throws Error where a
/// contact has the name of a loop and ties other frames.
std::vector<ContactSpec> with_loops(const Model& model, std::vector<ContactSpec> contacts,
                                    const LoopGains& gains = {});

/// Whether a contact is that of a loop of the model.
bool is_loop(const Model& model, const ContactSpec& contact);

/// Rows of a loop that those of its other directions, or of other loops, imply.
/// @described contact @result
struct RedundantLoop {
  std::string loop;
  Directions directions = Directions::linear();
};

/// What loops leave of the freedom of a robot.
/// @described contact @result
struct LoopFreedom {
  int rows = 0;                          ///< of all loops as described
  int rank = 0;                          ///< of their Jacobian
  int freedom = 0;                       ///< nv - rank
  std::vector<RedundantLoop> redundant;  ///< loops that have some
  /// "four_bar: z, rx, ry redundant", one line per loop.
  std::string text() const;
};
/// At the configuration q (nq). Throws Error for a bad q.
LoopFreedom loop_freedom(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// How a posture is moved onto the loops.
/// @described contact
struct LoopProjectionOptions {
  std::vector<std::string> keep = {};  ///< Joints that stay where they are.
  /// How dear a change of each entry of v is, nv positive numbers, or empty: all alike.
  Eigen::VectorXd weights = {};
  double tolerance = 1e-9;   ///< m and rad, of every row, > 0
  int max_iterations = 200;  ///< of all attempts, >= 1
  /// Revolute and prismatic joints stay within their limits, or where they start beyond them.
  bool within_limits = true;
};

/// How far a loop is from closed.
/// @described contact @result
struct LoopMiss {
  std::string loop;
  double translation = 0.0;  ///< [m], along the held directions
  double rotation = 0.0;     ///< [rad], about the held directions
};

/// A posture that closes the loops, or the nearest to one that was found.
/// @described contact @result
struct LoopProjection {
  Eigen::VectorXd q;             ///< nq
  std::vector<LoopMiss> misses;  ///< what is left, per loop
  int iterations = 0;
  Status status = Status::Ok;  ///< NotConverged: some loop is not closed

  /// "loop 'four_bar' cannot be closed from there: 12 mm are left"; empty where all are closed.
  std::string explanation() const;
};

/// Moves q (nq) onto the loops: damped Gauss-Newton steps on the configuration's manifold, of which
/// each is the least one in the metric of the weights (eq. (11.5) of docs/theory.md),
///   dq = -W^-1 J^T (J W^-1 J^T + damping)^-1 e.
/// Where that comes to rest with loops open, as at a dead point, it starts again from postures a
/// little beside q, always the same ones. Throws Error for a bad q and options out of range.
LoopProjection project_onto_loops(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                  const LoopProjectionOptions& options = {});

/// What is left of each loop at the configuration q (nq). Throws Error for a bad q.
std::vector<LoopMiss> loop_misses(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// What a change of velocity is measured by.
/// @described contact
enum class LoopMetric {
  Plain,  ///< |dv|^2, rad/s and m/s alike
  Mass,   ///< dv^T M dv: what impulses in the loops do
};
/// The velocity (nv) nearest to v that the loops allow at q: J v = 0 (eq. (11.6)). Joints of `keep`
/// keep theirs as far as the others can follow (plain metric alone). Throws Error for a bad q or v,
/// unknown joints, and a mass matrix that is singular.
Eigen::VectorXd project_velocity_onto_loops(const Model& model,
                                            const Eigen::Ref<const Eigen::VectorXd>& q,
                                            const Eigen::Ref<const Eigen::VectorXd>& v,
                                            LoopMetric metric = LoopMetric::Plain,
                                            const std::vector<std::string>& keep = {});

/// configuration() of the posture, moved onto the loops of the model: joints that the posture names
/// stay where it says if the others can close the loops, and move too otherwise, as rounded values
/// need. `keep`: joints to try to keep in place of those that the posture names. Throws Error as
/// configuration() does, and where the loops cannot be closed, with what is left.
Eigen::VectorXd closed_configuration(const Model& model, const Posture& posture);
Eigen::VectorXd closed_configuration(const Model& model, const Posture& posture,
                                     const std::vector<std::string>& keep);

}  // namespace burnish
