// Motions for the identification of a robot's mass parameters, and simulated records of such
// motions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "burnish/identify/identification.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/plant.hpp"

namespace burnish {

struct ExcitationSpec {
  /// Duration of the motion, from rest to rest [s]
  double duration = 10.0;
  /// Highest frequency of the motion [Hz]. All frequencies are multiples of 1/duration.
  double highest = 0.7;
  /// Largest distance of a joint from its start position [rad or m]
  double range = 0.8;
  /// Smallest distance of a joint from its position limits [rad or m]
  double margin = 0.1;
  /// Fraction of the velocity limits that the motion may use
  double speed_share = 0.4;
  /// Largest speed of a joint, also if its velocity limit is higher [rad/s or m/s]
  double speed = 2.0;
  /// Fraction of the effort limits that the motion may use. Torques are computed without the
  /// payload.
  double effort_share = 0.8;
  std::vector<std::string> joints = {};  ///< Names of the joints that move; empty: all joints
  int candidates = 40;                   ///< Number of random motions; the best one is used
  std::uint64_t seed = 1;
};

/// A motion for the identification of mass parameters. The motion starts and ends at rest in the
/// same configuration. Each joint follows a sum of harmonics, faded in and out (J. Swevers et al.,
/// "Optimal Robot Excitation and Identification", 1997).
class Excitation {
 public:
  /// Draws random motions and keeps the motion that is most informative about a payload at `frame`.
  /// This is the motion whose information matrix has the largest determinant. `q_start` is the
  /// start configuration (nq entries). Obstacles and collisions between the robot's own links are
  /// not considered.
  ///
  /// Throws Error, with a message of one sentence, for
  /// - unknown names and numbers out of range,
  /// - kinematic loops, and joints with more than one degree of freedom,
  /// - a start outside the joint limits or within `spec.margin` of a limit,
  /// - a start that needs more than `spec.effort_share` of an effort limit to hold,
  /// - limits that no random motion satisfies.
  Excitation(const Model& model, const Eigen::VectorXd& q_start, const std::string& frame,
             const ExcitationSpec& spec = {});

  double duration() const { return duration_; }
  /// Returns one warning if the effort limit of a joint reduced the motion; the warning names the
  /// joint. The list is empty if only position ranges and speed limits restrict the motion.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Evaluates the motion at `time` [s]: q (nq), v (nv) and a (nv). Before the start and after the
  /// end, the joints are at rest.
  void at(double time, Eigen::VectorXd& q, Eigen::VectorXd& v, Eigen::VectorXd& a) const;
  /// Returns the motion as a trace, with one row every `period` [s]. The columns are time,
  /// q_<joint>, v_<joint> and a_<joint>. Positions are angles [rad] or displacements [m], one
  /// number per joint, also for continuous joints.
  Trace trace(double period) const;

 private:
  struct Amplitudes {
    Eigen::MatrixXd sine, cosine;  ///< Amplitudes of the harmonics, nv x harmonics [rad or m]
    /// Scale of the motion; 1 for the largest motion that position ranges and speed limits permit
    double size = 1.0;
    int heaviest = 0;     ///< Entry of v with the largest ratio of torque to limit, for `size` 1
    double torque = 0.0;  ///< Torque at the entry `heaviest`, for `size` 1 [Nm or N]
  };
  bool limit(double effort_share);
  std::string effort_text(const Amplitudes& amplitudes, double effort_share) const;
  double information(const std::string& frame) const;
  void displacement_at(double time, Eigen::VectorXd& displacement, Eigen::VectorXd& v,
                       Eigen::VectorXd& a) const;

  Model model_;
  Eigen::VectorXd q_start_;
  double duration_;
  Amplitudes amplitudes_;
  std::vector<std::string> warnings_;
};

/// Simulates a plant that follows a motion in free space, and returns the trace. A computed-torque
/// controller tracks the motion at 1 kHz. The controller uses the model `known`, whose payload and
/// masses may differ from the plant's.
///
/// The motion starts once the plant is at rest. Throws Error in the same cases as ClosedLoop, and
/// if the simulation fails.
Trace record_motion(Plant& plant, const Model& known, const Excitation& motion,
                    const Disturbances& disturbances);
/// Simulates the ideal plant with `payload` while it follows a motion in free space, and returns
/// the trace. The computed-torque controller uses `model`, which does not include the payload.
Trace record_motion(const Model& model, const Payload& payload, const Excitation& motion,
                    const Disturbances& disturbances);

/// Compares a trace of record_motion() with the planned motion. Returns a warning for each joint
/// that deviates by more than a quarter of a turn and by more than the range of its planned motion.
/// Such deviations are possible for light wrists if the controller's model lacks the payload.
///
/// Throws Error if the arm falls. This means that a joint deviates by more than 0.1 rad (m) while
/// its torque is at the effort limit. The message names joint, deviation and time.
std::vector<std::string> check_followed(const Model& known, const Excitation& motion,
                                        const Trace& trace);

}  // namespace burnish
