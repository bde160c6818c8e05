// Motions that show what a robot weighs, and records of simulated ones.
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
  double duration = 10.0;     ///< s, from rest to rest
  double highest = 0.7;       ///< Hz, of the harmonics of 1/duration that joints move with
  double range = 0.8;         ///< rad (m) that joints leave their start at most
  double margin = 0.1;        ///< rad (m) that they keep from their limits
  double speed_share = 0.4;   ///< of velocity limits that is used
  double speed = 2.0;         ///< rad/s (m/s) that are used at most, limits or none
  double effort_share = 0.8;  ///< of effort limits, of the robot without a payload
  std::vector<std::string> joints = {};  ///< that move; empty: all
  int candidates = 40;                   ///< drawn, of which the one is taken that shows most
  std::uint64_t seed = 1;
};

/// A motion from rest to rest about a configuration: per joint a sum of harmonics, faded in and out
/// (J. Swevers et al., "Optimal Robot Excitation and Identification", 1997).
class Excitation {
 public:
  /// The one of several drawn at random that tells most of a payload at `frame`: whose information
  /// has the largest determinant. q_start: nq. Throws Error with one sentence for names that the
  /// robot does not know, numbers out of range, joints of several entries, a start that is outside
  /// the limits, and a start that takes more than `effort_share` of an effort limit to hold. It
  /// knows no obstacles, the robot's own links included.
  Excitation(const Model& model, const Eigen::VectorXd& q_start, const std::string& frame,
             const ExcitationSpec& spec = {});

  double duration() const { return duration_; }
  /// Sentences: whose effort limit made the motion smaller than range and speeds allow.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// At a time (s; held before and after): q (nq), v and a (nv).
  void at(double time, Eigen::VectorXd& q, Eigen::VectorXd& v, Eigen::VectorXd& a) const;
  /// Columns time, q_<joint>, v_<joint>, a_<joint>, every `period` s. Positions are angles [rad],
  /// of continuous joints too, or displacements [m].
  Trace trace(double period) const;

 private:
  struct Drawn {
    Eigen::MatrixXd sine, cosine;  ///< nv x harmonics, rad (m)
    double size = 1.0;             ///< of the motion that range and speeds allow
    int heaviest = 0;              ///< entry of v whose torque is nearest to its limit at size 1
    double torque = 0.0;           ///< of that entry [Nm, N]
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

/// What a plant records while it follows a motion, in the air, by computed torque of the model that
/// is known, at 1 kHz and from where it came to rest: the plant's model may carry and weigh what
/// that one does not. Throws Error as ClosedLoop does, and where the simulation fails.
Trace record_motion(Plant& plant, const Model& known, const Excitation& motion,
                    const Disturbances& disturbances);
/// The same of the ideal plant with a payload that the model does not know.
Trace record_motion(const Model& model, const Payload& payload, const Excitation& motion,
                    const Disturbances& disturbances);

/// Compares a trace of record_motion() with the motion. Returns sentences about joints that are
/// further from it than they were to move and than a quarter of a turn: light wrists swing with a
/// payload that the controller does not know. Throws Error, naming joint, deviation and time, for
/// an arm that falls: a joint is more than 0.1 rad (m) from the motion while its torque is at its
/// effort limit.
std::vector<std::string> check_followed(const Model& known, const Excitation& motion,
                                        const Trace& trace);

}  // namespace burnish
