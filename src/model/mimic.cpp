#include "model/mimic.hpp"

#include <cmath>

#include "model/posture.hpp"
#include "model/tree_sentence.hpp"

namespace burnish {
namespace {

bool slides(const JointSpec& joint) { return joint.type == JointType::Prismatic; }
bool turns_endlessly(const JointSpec& joint) { return joint.type == JointType::Continuous; }

/// Returns true for whole numbers up to a million. A larger multiplier would lose the digits of an
/// angle.
bool is_whole(double multiplier) {
  return std::abs(multiplier) <= 1e6 && multiplier == std::nearbyint(multiplier);
}

}  // namespace

const JointSpec& find_joint(const TreeSpec& tree, const JointByName& joints,
                            const std::string& name, const std::string& what) {
  const auto found = joints.find(name);
  if (found != joints.end()) return *found->second;
  std::vector<std::string> existing;
  for (const JointSpec& joint : tree.joints) existing.push_back(joint.name);
  refuse(tree, what + " " + in_quotes(name) + " does not exist" + did_you_mean(name, existing));
}

const JointSpec& named_leader(const TreeSpec& tree, const JointByName& joints,
                              const JointSpec& follower) {
  return find_joint(tree, joints, follower.mimic->leader,
                    "mimic joint " + in_quotes(follower.name) + ": its leader");
}

Courses::Courses(const TreeSpec& tree, const JointByName& joints,
                 const std::set<std::string>& locked, const Posture& posture)
    : tree_(tree), joints_(joints), locked_(locked), posture_(posture) {}

Course Courses::of(const JointSpec& joint) {
  if (const auto found = cached_.find(&joint); found != cached_.end()) return found->second;
  if (!in_progress_.insert(&joint).second) {
    refuse(tree_, "joint " + in_quotes(joint.name) +
                      " follows itself, directly or through other joints; wanted a leader that "
                      "follows no joint");
  }
  Course course;
  if (locked_.contains(joint.name)) {
    course = held_by_lock(joint);
  } else if (joint.type == JointType::Fixed) {
    course = {};
  } else if (joint.mimic) {
    course = through_leader(joint);
  } else {
    course = {&joint, 1.0, 0.0};
  }
  in_progress_.erase(&joint);
  cached_.emplace(&joint, course);
  return course;
}

Course Courses::through_leader(const JointSpec& joint) {
  const JointSpec& leader = named_leader(tree_, joints_, joint);
  if (posture_size(joint.type) != 1) {
    refuse(tree_, "joint " + in_quotes(joint.name) +
                      " follows another joint but does not have exactly one coordinate; wanted a "
                      "revolute, continuous or prismatic joint");
  }
  if (posture_size(leader.type) > 1) {
    refuse(tree_, "joint " + in_quotes(joint.name) + " follows joint " + in_quotes(leader.name) +
                      ", which has more than one coordinate; wanted a revolute, continuous or "
                      "prismatic joint");
  }
  const Course above = of(leader);
  const MimicSpec& mimic = *joint.mimic;
  if (above.leader != nullptr) {
    check_multiplier(joint, leader, above);
    return {above.leader, mimic.multiplier * above.multiplier,
            mimic.multiplier * above.offset + mimic.offset};
  }
  const double value = mimic.multiplier * above.offset + mimic.offset;
  const auto stated = posture_.find(joint.name);
  if (stated != posture_.end() && !locked_.contains(joint.name) &&
      std::abs(stated->second[0] - value) > posture_tolerance) {
    refuse(tree_, "joint " + in_quotes(joint.name) + " is at " + number(stated->second[0]) +
                      " in the posture, but follows joint " + in_quotes(leader.name) +
                      ", which is locked at " + number(above.offset) +
                      ", so the follower must be at " + number(value) +
                      "; correct one of the two values, or lock " + in_quotes(joint.name) +
                      " too, at its own value");
  }
  return {nullptr, 0.0, value};
}

Course Courses::held_by_lock(const JointSpec& joint) {
  const auto stated = posture_.find(joint.name);
  if (stated != posture_.end()) return {nullptr, 0.0, stated->second[0]};
  if (!joint.mimic) return {};
  const Course course = through_leader(joint);
  if (course.leader == nullptr) return course;
  const std::string leader = in_quotes(joint.mimic->leader);
  refuse(tree_, "joint " + in_quotes(joint.name) + " is locked but follows joint " + leader +
                    ", which moves; lock " + leader + " too or give " + in_quotes(joint.name) +
                    " a value in the posture");
}

void Courses::check_multiplier(const JointSpec& joint, const JointSpec& leader,
                               const Course& above) const {
  const double multiplier = joint.mimic->multiplier;
  const bool on_circle = turns_endlessly(*above.leader);
  if (on_circle && slides(joint) && multiplier * above.multiplier != 0.0) {
    refuse(tree_,
           "joint " + in_quotes(joint.name) + " is prismatic, but follows the continuous joint " +
               in_quotes(above.leader->name) +
               "; wanted a revolute leader, because the angle of a continuous joint does not "
               "count its turns");
  }
  if (!(on_circle || turns_endlessly(joint) || turns_endlessly(leader)) || is_whole(multiplier))
    return;
  const JointSpec& endless = turns_endlessly(joint)    ? joint
                             : turns_endlessly(leader) ? leader
                                                       : *above.leader;
  refuse(tree_, "joint " + in_quotes(joint.name) + " follows joint " + in_quotes(leader.name) +
                    " with the multiplier " + number(multiplier) + ", but joint " +
                    in_quotes(endless.name) +
                    " is continuous; wanted a revolute joint, or a whole multiplier of at most a "
                    "million, because other multiples of the angle of a "
                    "continuous joint are not unique");
}

}  // namespace burnish
