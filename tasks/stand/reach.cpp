#include "stand/reach.hpp"

#include <array>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "pressing/foot_posture.hpp"
#include "pressing/stage_terms.hpp"
#include "pressing/standing_terms.hpp"
#include "pressing/statics.hpp"

namespace burnish::stand {
namespace {

/// Names of the six amplitudes of the sway: three shifts, three turns.
constexpr std::array names{"x", "y", "z", "roll", "pitch", "yaw"};

double& amplitude(Sway& sway, int direction) {
  return direction < 3 ? sway.shift[direction] : sway.turn[direction - 3];
}
double amplitude(const Sway& sway, int direction) {
  return direction < 3 ? sway.shift[direction] : sway.turn[direction - 3];
}

/// Returns the solver that checks whether the robot can stand at rest. Its limits on feet and
/// torques equal those of the plans.
pressing::Statics make_statics(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  pressing::StaticsSpec spec{
      .feet = pressing::within_plans(setting.scene.touches, setting.standing),
      .min_load = pressing::min_load_of(model, setting.standing),
      .torque_limit = pressing::torque_limit(model, task.constraints)};
  return {model, spec};
}

/// Tests whether postures with a moved trunk exist, and whether the robot can stand in them.
class Reach {
 public:
  Reach(const Task& task, const Setting& setting)
      : task_(task),
        setting_(setting),
        model_(setting.robot.model),
        statics_(make_statics(task, setting)),
        body_(model_) {
    for (const std::string& foot : setting.standing.feet)
      wanted_.feet.push_back(frame_placement(model_, setting.q_start, foot));
  }

  /// Returns an error if the robot cannot stand in the start posture, else nothing.
  std::optional<EntryError> error_at_start() {
    return check_statics(setting_.q_start, "posture", "at the start");
  }
  /// Checks the points of the sway of `setting` in order. Returns the first error, or nothing.
  std::optional<EntryError> error_in_sway(const Setting& setting) {
    constexpr int samples = 100;  // number of checked points of the sway
    Eigen::VectorXd q = setting.q_start;
    for (int i = 0; i <= samples; ++i) {
      const double since = task_.sway_duration * i / samples;
      const std::string where = number(since) + " s into the sway";
      if (!move(trunk_at(task_, setting, task_.settle_duration + since), 1e-4, q))
        return EntryError("sway",
                          "no posture on these feet and within the joints' limits has the trunk at "
                          "its target " +
                              where + "; wanted a smaller sway");
      if (auto error = check_statics(q, "sway", where)) return error;
    }
    return std::nullopt;
  }
  /// Returns whether the trunk can move by + and - `amplitude` [m (rad)] along `direction`.
  bool reaches(int direction, double amplitude) {
    // The tolerance is tight. Otherwise, position errors of the feet would count as motion of the
    // trunk.
    constexpr double tolerance = 1e-7;
    constexpr int steps = 4;
    for (const double side : {-amplitude, amplitude}) {
      Eigen::VectorXd q = setting_.q_start;
      for (int i = 1; i <= steps; ++i)
        if (!move(trunk_beside(direction, side * i / steps), tolerance, q)) return false;
      if (check_statics(q, "sway", "")) return false;
    }
    return true;
  }

 private:
  Trunk trunk_beside(int direction, double offset) const {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(), axis = shift;
    (direction < 3 ? shift : axis)[direction % 3] = direction < 3 ? offset : 1.0;
    Trunk trunk{setting_.com + setting_.heading * shift, Eigen::Vector3d::Zero(), setting_.R_base};
    if (direction >= 3)
      trunk.base =
          Eigen::AngleAxisd(offset, setting_.heading * axis).toRotationMatrix() * trunk.base;
    return trunk;
  }
  bool move(const Trunk& trunk, double tolerance, Eigen::VectorXd& q) {
    wanted_.com = trunk.com;
    wanted_.R_base = trunk.base;
    const auto found = pressing::posture_on_feet(model_, setting_.standing, wanted_, q, tolerance);
    if (found) q = *found;
    return found.has_value();
  }
  /// Returns an error for `entry` if the robot cannot stand in the posture q, else nothing.
  std::optional<EntryError> check_statics(const Eigen::VectorXd& q, const std::string& entry,
                                          const std::string& where) {
    if (!is_usable(body_.update(q, Eigen::VectorXd::Zero(model_.nv))))
      return EntryError(entry, "a posture " + where + " cannot be evaluated");
    if (statics_.max_force(body_) >= 0.0) return std::nullopt;
    const std::string& limit = statics_.name(statics_.limit());
    const bool loaded = limit.starts_with("load of ");
    return EntryError(
        entry, "the robot, which weighs " + number(model_.total_mass() * model_.gravity.norm()) +
                   " N, cannot stand " + where + " without violating the plans' constraint " +
                   in_quotes(limit) +
                   (loaded ? ", which must be at least " +
                                 number(pressing::min_load_of(model_, setting_.standing)) +
                                 " N; wanted another posture, or a smaller standing.min_load"
                           : "; wanted another posture, or a smaller sway"));
  }

  const Task& task_;
  const Setting& setting_;
  const Model& model_;
  pressing::Statics statics_;
  RigidBody body_;
  pressing::FootPosture wanted_;
};

/// Returns the task's sway, with shifts limited to a fraction of the height of the centre of mass.
Sway sway_for_height(const Task& task, const Setting& setting) {
  // Largest shift as a fraction of the height of the centre of mass; slightly larger than in the
  // shipped tasks.
  const double max_shift = setting.standing.has_soles() ? 0.05 : 0.11;
  const double height = setting.com.z() - setting.ground.point.z();
  Sway sway = task.sway;
  sway.shift = sway.shift.cwiseMin(max_shift * height).cwiseMax(-max_shift * height);
  return sway;
}

/// Returns the sway, each amplitude scaled by the largest of `fractions` at which the trunk can
/// move in the direction of this amplitude alone. An amplitude that is never reached becomes 0.
Sway reached_one_by_one(const Sway& whole, Reach& reach) {
  constexpr std::array fractions{1.0, 0.7, 0.5, 0.35, 0.25};
  Sway sway = whole;
  for (int d = 0; d < 6; ++d) {
    const double wanted = amplitude(whole, d);
    if (wanted == 0.0) continue;
    double& now = amplitude(sway, d);
    now = 0.0;
    for (const double fraction : fractions)
      if (now == 0.0 && reach.reaches(d, fraction * wanted)) now = fraction * wanted;
  }
  return sway;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace

Sway fitted_sway(const Task& task, const Setting& setting) {
  constexpr double reduction = 0.7;  // factor on the sway per try
  constexpr int max_tries = 8;       // the last try has 0.08 of the sway
  if (!setting.robot.model.loops.empty()) return task.sway;
  Reach reach(task, setting);
  if (reach.error_at_start()) return task.sway;
  Setting tried = setting;
  tried.sway = sway_for_height(task, setting);
  if (!reach.error_in_sway(tried)) return tried.sway;
  tried.sway = reached_one_by_one(tried.sway, reach);
  for (int i = 0; i < max_tries; ++i) {
    if (!reach.error_in_sway(tried)) return tried.sway;
    tried.sway.shift *= reduction;
    tried.sway.turn *= reduction;
  }
  tried.sway.shift.setZero();
  tried.sway.turn.setZero();
  return tried.sway;
}

std::vector<std::string> sway_notes(const Task& task, const Setting& setting) {
  std::vector<std::string> left_out, made_smaller;
  for (int d = 0; d < 6; ++d) {
    const double wanted = amplitude(task.sway, d), now = amplitude(setting.sway, d);
    if (now == wanted) continue;
    const std::string unit = d < 3 ? " m" : " rad";
    if (now == 0.0)
      left_out.emplace_back(names[to_size(d)]);
    else
      made_smaller.push_back(std::string(names[to_size(d)]) + " " + number(now) + " in place of " +
                             number(wanted) + unit);
  }
  std::vector<std::string> notes;
  if (!left_out.empty())
    notes.push_back(
        "sway: " + joined(left_out) + (left_out.size() == 1 ? " is" : " are") +
        " omitted, because no posture on these feet moves the trunk in that direction alone");
  if (!made_smaller.empty())
    notes.push_back("sway: amplitudes are reduced to fit the size and reach of the robot: " +
                    joined(made_smaller));
  return notes;
}

void refuse_out_of_reach(const Task& task, const Setting& setting) {
  // Skips robots with closed loops, which Statics does not model.
  if (!setting.robot.model.loops.empty()) return;
  Reach reach(task, setting);
  if (auto error = reach.error_at_start()) throw EntryError(*error);
  if (auto error = reach.error_in_sway(setting)) throw EntryError(*error);
}

}  // namespace burnish::stand
