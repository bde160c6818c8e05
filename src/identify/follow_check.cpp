// Check that a simulated record followed its planned motion.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/identify/excitation.hpp"
#include "burnish/model/state.hpp"

namespace burnish {
namespace {

/// Distance from the planned motion [rad, m]. A joint that is farther away while its torque command
/// exceeds the limit counts as falling. The value is the default of ExcitationSpec::margin.
constexpr double falls_beyond = 0.1;
/// Deviations up to this distance, a quarter of a turn, give no warning, even if the planned range
/// is smaller [rad, m]. The light last joint of arm7 deviates by 0.95 rad with seed 2007 of
/// `burnish identify --seeds`.
constexpr double follows_within = 0.5 * std::numbers::pi;

/// Deviation of a joint from its planned motion.
struct JointDeviation {
  double farthest = 0.0;  ///< Largest distance from the motion [rad, m]
  double at = 0.0;        ///< Time of the largest distance [s]
  /// Time at which the distance first exceeds `falls_beyond` [s]; negative: it never does
  double left_at = -1.0;
  double low = 0.0, high = 0;  ///< Range of the planned path, relative to its start [rad, m]
  bool falls = false;          ///< Command above the effort limit, distance above `falls_beyond`
};

std::vector<JointDeviation> followings(const Model& model, const Excitation& motion,
                                       const Trace& trace) {
  std::vector<JointDeviation> result(to_size(model.nv));
  std::vector<int> q_columns, tau_columns;
  for (int k = 0; k < model.nq; ++k) q_columns.push_back(trace.index("q_" + model.q_name(k)));
  for (int k = 0; k < model.nv; ++k)
    tau_columns.push_back(trace.index("tau_command_" + model.v_name(k)));
  const int time = trace.index("time");
  Eigen::VectorXd start, planned, v, a, q(model.nq);
  motion.at(0.0, start, v, a);
  for (int i = 0; i < trace.rows(); ++i) {
    const double t = trace.at(i, time);
    motion.at(t, planned, v, a);
    for (int k = 0; k < model.nq; ++k) q[k] = trace.at(i, q_columns[to_size(k)]);
    const Eigen::VectorXd off = difference(model, planned, normalized(model, q));
    const Eigen::VectorXd path = difference(model, start, planned);
    for (int k = 0; k < model.nv; ++k) {
      JointDeviation& joint = result[to_size(k)];
      const double distance = std::abs(off[k]);
      if (distance > joint.farthest) joint.farthest = distance, joint.at = t;
      if (distance > falls_beyond && joint.left_at < 0.0) joint.left_at = t;
      joint.low = std::min(joint.low, path[k]);
      joint.high = std::max(joint.high, path[k]);
      const double tau = trace.at(i, tau_columns[to_size(k)]);
      joint.falls =
          joint.falls || (distance > falls_beyond && std::abs(tau) > model.effort_limit[k]);
    }
  }
  return result;
}

bool slides(const Model& model, int entry) {
  const int owner = model.joint_of_v[to_size(entry)];
  return model.joints[to_size(owner)].kind == JointKind::Prismatic;
}

/// Returns a distance with two decimals, such as "0.48 rad".
std::string distance_text(const Model& model, int entry, double distance) {
  return number(std::round(100.0 * distance) / 100.0) + (slides(model, entry) ? " m" : " rad");
}

std::string leaving_text(const Model& model, int entry, const JointDeviation& joint) {
  return "joint " + in_quotes(model.v_name(entry)) + " leaves the planned motion at " +
         number(joint.left_at) + " s and is " + distance_text(model, entry, joint.farthest) +
         " from it at " + number(joint.at) + " s";
}

}  // namespace

std::vector<std::string> check_followed(const Model& known, const Excitation& motion,
                                        const Trace& trace) {
  const std::vector<JointDeviation> joints = followings(known, motion, trace);
  std::vector<std::string> warnings;
  int first = -1;  // First joint that falls
  for (int k = 0; k < known.nv; ++k) {
    const JointDeviation& joint = joints[to_size(k)];
    if (joint.left_at < 0.0) continue;
    const bool is_first = first < 0 || joint.left_at < joints[to_size(first)].left_at;
    if (joint.falls && is_first) first = k;
    const double extent = joint.high - joint.low;
    if (!joint.falls && joint.farthest > std::max(extent, follows_within))
      warnings.push_back(leaving_text(known, k, joint) + ", more than its planned range of " +
                         distance_text(known, k, extent) +
                         ": the payload is heavy for this joint, and the simulated controller has "
                         "no model of the payload");
  }
  if (first >= 0)
    throw Error("the simulated arm cannot follow the motion: " +
                leaving_text(known, first, joints[to_size(first)]) +
                ", with its torque at its effort limit of " + number(known.effort_limit[first]) +
                (slides(known, first) ? " N" : " Nm") +
                "; wanted a start that is easier to hold (--posture), a smaller range (--range) or "
                "a lighter payload (--seed)");
  return warnings;
}

}  // namespace burnish
