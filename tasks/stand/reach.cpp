#include "stand/reach.hpp"

#include <array>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "pressing/bearing.hpp"
#include "pressing/foot_posture.hpp"
#include "pressing/stage_terms.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::stand {
namespace {

/// Names of the sway's six amplitudes: shifts, then turns.
constexpr std::array names{"x", "y", "z", "roll", "pitch", "yaw"};

double& amplitude(Sway& sway, int direction) {
  return direction < 3 ? sway.shift[direction] : sway.turn[direction - 3];
}
double amplitude(const Sway& sway, int direction) {
  return direction < 3 ? sway.shift[direction] : sway.turn[direction - 3];
}

/// What the feet bear at rest within the limits that plans keep.
pressing::Bearing make_bearing(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  pressing::BearingSpec spec{
      .feet = pressing::within_plans(setting.scene.supports, setting.standing),
      .least_load = pressing::least_load_of(model, setting.standing),
      .torque_limit = pressing::torque_limit(model, task.constraints)};
  return {model, spec};
}

/// Whether the robot has postures with its trunk elsewhere, and bears itself in them.
class Reach {
 public:
  Reach(const Task& task, const Setting& setting)
      : task_(task),
        setting_(setting),
        model_(setting.robot.model),
        bearing_(make_bearing(task, setting)),
        body_(model_) {
    for (const std::string& foot : setting.standing.feet)
      wanted_.feet.push_back(frame_placement(model_, setting.q_start, foot));
  }

  /// What is in the way at the start; nothing, or its sentence.
  std::optional<EntryError> trouble_at_start() {
    return unborne(setting_.q_start, "posture", "at the start");
  }
  /// What is first in the way of the setting's sway.
  std::optional<EntryError> trouble_on_the_way(const Setting& setting) {
    constexpr int places = 100;  // on the way, that are looked at
    Eigen::VectorXd q = setting.q_start;
    for (int i = 0; i <= places; ++i) {
      const double since = task_.sway_duration * i / places;
      const std::string where = number(since) + " s into its sway";
      if (!move(trunk_at(task_, setting, task_.settle_duration + since), 1e-4, q))
        return EntryError("sway",
                          "no posture on these feet, with joints in their ranges, has the trunk "
                          "where it is to be " +
                              where + "; wanted less of it");
      if (auto error = unborne(q, "sway", where)) return error;
    }
    return std::nullopt;
  }
  /// Whether the trunk comes that far in one direction, to both sides.
  bool comes(int direction, double far) {
    // Tight, so that feet which could give way by so little do not count as legs that move.
    constexpr double tolerance = 1e-7;
    constexpr int steps = 4;
    for (const double side : {-far, far}) {
      Eigen::VectorXd q = setting_.q_start;
      for (int i = 1; i <= steps; ++i)
        if (!move(trunk_beside(direction, side * i / steps), tolerance, q)) return false;
      if (unborne(q, "sway", "")) return false;
    }
    return true;
  }

 private:
  Trunk trunk_beside(int direction, double far) const {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(), axis = shift;
    (direction < 3 ? shift : axis)[direction % 3] = direction < 3 ? far : 1.0;
    Trunk trunk{setting_.com + setting_.heading * shift, Eigen::Vector3d::Zero(), setting_.R_base};
    if (direction >= 3)
      trunk.base = Eigen::AngleAxisd(far, setting_.heading * axis).toRotationMatrix() * trunk.base;
    return trunk;
  }
  bool move(const Trunk& trunk, double tolerance, Eigen::VectorXd& q) {
    wanted_.com = trunk.com;
    wanted_.R_base = trunk.base;
    const auto found = pressing::posture_on_feet(model_, setting_.standing, wanted_, q, tolerance);
    if (found) q = *found;
    return found.has_value();
  }
  std::optional<EntryError> unborne(const Eigen::VectorXd& q, const std::string& entry,
                                    const std::string& where) {
    if (body_.update(q, Eigen::VectorXd::Zero(model_.nv)) > Status::NotConverged)
      return EntryError(entry, "a posture " + where + " cannot be evaluated");
    if (bearing_.most(body_) >= 0.0) return std::nullopt;
    const std::string& limit = bearing_.name(bearing_.limit());
    const bool loaded = limit.starts_with("load of ");
    return EntryError(
        entry, "the robot, which weighs " + number(model_.total_mass() * model_.gravity.norm()) +
                   " N, cannot stand " + where + " within what plans keep: in the way is the " +
                   limit +
                   (loaded ? ", " + number(pressing::least_load_of(model_, setting_.standing)) +
                                 " N; wanted another posture, or less of standing.least_load"
                           : "; wanted another posture, or less of a sway"));
  }

  const Task& task_;
  const Setting& setting_;
  const Model& model_;
  pressing::Bearing bearing_;
  RigidBody body_;
  pressing::FootPosture wanted_;
};

/// The task's sway with shifts that suit the robot's height.
Sway sway_for_height(const Task& task, const Setting& setting) {
  // Of the height of the centre of mass: a little more than the shipped tasks ask for.
  const double most = setting.standing.has_soles() ? 0.05 : 0.11;
  const double height = setting.com.z() - setting.scene.surface.point.z();
  Sway sway = task.sway;
  sway.shift = sway.shift.cwiseMin(most * height).cwiseMax(-most * height);
  return sway;
}

/// Of each amplitude the largest of these parts that the trunk comes to by itself; 0: none.
Sway reached_one_by_one(const Sway& whole, Reach& reach) {
  constexpr std::array parts{1.0, 0.7, 0.5, 0.35, 0.25};
  Sway sway = whole;
  for (int d = 0; d < 6; ++d) {
    const double wanted = amplitude(whole, d);
    if (wanted == 0.0) continue;
    double& now = amplitude(sway, d);
    now = 0.0;
    for (const double part : parts)
      if (now == 0.0 && reach.comes(d, part * wanted)) now = part * wanted;
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
  constexpr double smaller = 0.7;
  constexpr int most = 8;  // times smaller: 0.06 of it
  if (!setting.robot.model.loops.empty()) return task.sway;
  Reach reach(task, setting);
  if (reach.trouble_at_start()) return task.sway;
  Setting tried = setting;
  tried.sway = sway_for_height(task, setting);
  if (!reach.trouble_on_the_way(tried)) return tried.sway;
  tried.sway = reached_one_by_one(tried.sway, reach);
  for (int i = 0; i < most; ++i) {
    if (!reach.trouble_on_the_way(tried)) return tried.sway;
    tried.sway.shift *= smaller;
    tried.sway.turn *= smaller;
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
      left_out.emplace_back(names[static_cast<std::size_t>(d)]);
    else
      made_smaller.push_back(std::string(names[static_cast<std::size_t>(d)]) + " " + number(now) +
                             " in place of " + number(wanted) + unit);
  }
  std::vector<std::string> notes;
  if (!left_out.empty())
    notes.push_back("sway: " + joined(left_out) +
                    " left out: no posture on these feet moves the trunk there alone");
  if (!made_smaller.empty())
    notes.push_back("sway: made smaller for the size and the reach of the robot: " +
                    joined(made_smaller));
  return notes;
}

void refuse_out_of_reach(const Task& task, const Setting& setting) {
  // What closed chains bear is not known from the tree alone.
  if (!setting.robot.model.loops.empty()) return;
  Reach reach(task, setting);
  if (auto error = reach.trouble_at_start()) throw EntryError(*error);
  if (auto error = reach.trouble_on_the_way(setting)) throw EntryError(*error);
}

}  // namespace burnish::stand
