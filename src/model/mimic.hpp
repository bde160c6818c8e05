// What becomes of joints that mimic others: held, or following one that moves by itself.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "burnish/model/model.hpp"

namespace burnish {

using JointByName = std::unordered_map<std::string, const JointSpec*>;

/// The joint of that name; `what` says whose it is. Throws Error with the nearest known name.
const JointSpec& find_joint(const TreeSpec& tree, const JointByName& joints,
                            const std::string& name, const std::string& what);

/// The leader that a mimic joint names.
const JointSpec& named_leader(const TreeSpec& tree, const JointByName& joints,
                              const JointSpec& follower);

/// The value of a joint of one coordinate: multiplier * value of the leader + offset.
struct Course {
  const JointSpec* leader = nullptr;  ///< moves by itself; nullptr where the joint is held
  double multiplier = 0.0;
  double offset = 0.0;  ///< where it is held
};

/// The courses of a tree's joints, with those of `locked` held as ModelOptions says.
class Courses {
 public:
  /// Keeps references to all arguments.
  Courses(const TreeSpec& tree, const JointByName& joints, const std::set<std::string>& locked,
          const Posture& posture);

  /// Of a joint of one coordinate, or of a fixed one. Throws Error naming the joints where one
  /// follows itself, where a multiplier has no meaning on the circle, where a locked joint follows
  /// one that moves, and where the posture contradicts a leader that is held.
  Course of(const JointSpec& joint);

 private:
  Course through_leader(const JointSpec& joint);
  Course held_by_lock(const JointSpec& joint);
  void check_multiplier(const JointSpec& joint, const JointSpec& leader, const Course& above) const;

  const TreeSpec& tree_;
  const JointByName& joints_;
  const std::set<std::string>& locked_;
  const Posture& posture_;
  std::map<const JointSpec*, Course> known_;
  std::set<const JointSpec*> under_way_;
};

}  // namespace burnish
