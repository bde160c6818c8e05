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
  /// Fraction of the effort limits that the motion may use. The payload's torque is not included.
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
  /// Draws random motions and chooses the most informative one about a payload at `frame`: the
  /// motion whose information matrix has the largest determinant. `q_start` has nq entries.
  /// Obstacles and collisions between the robot's own links are not considered.
  ///
  /// Throws Error, with a message of one sentence, for
  /// - unknown names and numbers out of range,
  /// - joints of several entries, and kinematic loops,
  /// - a start outside the joint limits or within `margin` of a limit,
  /// - a start that needs more than `effort_share` of an effort limit to hold,
  /// - limits that no random motion satisfies.
  Excitation(const Model& model, const Eigen::VectorXd& q_start, const std::string& frame,
             const ExcitationSpec& spec = {});

  double duration() const { return duration_; }
  /// Returns a warning if an effort limit reduced the motion, which names the joint. Position
  /// ranges and speed limits alone would permit a larger motion.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Evaluates the motion at `time` [s]: q (nq), v (nv) and a (nv). Before the start and after the
  /// end, the joints are at rest.
  void at(double time, Eigen::VectorXd& q, Eigen::VectorXd& v, Eigen::VectorXd& a) const;
  /// Returns the motion as a trace, with a row every `period` [s] and the columns time, q_<joint>,
  /// v_<joint>, a_<joint>. Positions are angles [rad], also for continuous joints, or displacements
  /// [m].
  Trace trace(double period) const;

 private:
  struct Drawn {
    Eigen::MatrixXd sine, cosine;  ///< Amplitudes of the harmonics, nv x harmonics [rad or m]
    /// Scale of the motion; 1 for the largest motion that range and speeds permit
    double size = 1.0;
    int heaviest = 0;     ///< Entry of v with the largest torque relative to its limit, at size 1
    double torque = 0.0;  ///< Torque of the entry `heaviest` at size 1 [Nm or N]
  };
  bool limit(double effort_share);
  std::string effort_text(const Drawn& drawn, double effort_share) const;
  double information(const std::string& frame) const;
  void way_at(double time, Eigen::VectorXd& way, Eigen::VectorXd& v, Eigen::VectorXd& a) const;

  Model model_;
  Eigen::VectorXd q_start_;
  double duration_;
  Drawn drawn_;
  std::vector<std::string> warnings_;
};

/// Simulates a plant that follows a motion in free space, and returns the trace. The controller is
/// a computed-torque controller with the model `known`, at 1 kHz. The plant's model may have
/// another payload and other masses.
///
/// The motion starts after the plant has come to rest. Throws Error in the same cases as
/// ClosedLoop, and if the simulation fails.
Trace record_motion(Plant& plant, const Model& known, const Excitation& motion,
                    const Disturbances& disturbances);
/// Simulates the ideal plant with `payload` while it follows a motion in free space, and returns
/// the trace. The computed-torque controller uses `model`, which does not include the payload.
Trace record_motion(const Model& model, const Payload& payload, const Excitation& motion,
                    const Disturbances& disturbances);

/// Compares a trace of record_motion() with the planned motion. Returns a warning for each joint
/// that deviates by more than a quarter of a turn and by more than the extent of its planned
/// motion. Light wrists can deviate by this much if the controller's model does not include the
/// payload.
///
/// Throws Error if the arm falls: a joint deviates by more than 0.1 rad (m) while its torque is at
/// the effort limit. The message names joint, deviation and time.
std::vector<std::string> check_followed(const Model& known, const Excitation& motion,
                                        const Trace& trace);

}  // namespace burnish
