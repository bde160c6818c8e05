// Resolution of joints that mimic others. Such a joint is held, or follows a joint that moves by
// itself.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "burnish/model/model.hpp"

namespace burnish {

using JointByName = std::unordered_map<std::string, const JointSpec*>;

/// Returns the joint with this name. If it does not exist, throws Error with the nearest name. The
/// message begins with `what`, the role of the joint.
const JointSpec& find_joint(const TreeSpec& tree, const JointByName& joints,
                            const std::string& name, const std::string& what);

/// Returns the joint that a mimic joint names as its leader.
const JointSpec& named_leader(const TreeSpec& tree, const JointByName& joints,
                              const JointSpec& follower);

/// Position of a joint with one coordinate: multiplier * position of the leader + offset.
struct Course {
  const JointSpec* leader = nullptr;  ///< Joint that moves by itself; nullptr if the joint is held
  double multiplier = 0.0;
  double offset = 0.0;  ///< Position of the joint if it is held [rad, m]
};

/// Courses of a tree's joints. The joints `locked` are held as ModelOptions describes.
class Courses {
 public:
  /// Keeps references to all arguments.
  Courses(const TreeSpec& tree, const JointByName& joints, const std::set<std::string>& locked,
          const Posture& posture);

  /// Returns the course of a joint with one coordinate, or of a fixed joint. Throws Error with the
  /// names of the joints in these cases:
  ///  - a joint follows itself;
  ///  - a multiplier is invalid for a continuous joint;
  ///  - a locked joint without a value in the posture follows a moving joint;
  ///  - the posture contradicts a leader that is held.
  Course of(const JointSpec& joint);

 private:
  Course through_leader(const JointSpec& joint);
  Course held_by_lock(const JointSpec& joint);
  void check_multiplier(const JointSpec& joint, const JointSpec& leader, const Course& above) const;

  const TreeSpec& tree_;
  const JointByName& joints_;
  const std::set<std::string>& locked_;
  const Posture& posture_;
  std::map<const JointSpec*, Course> cached_;
  std::set<const JointSpec*> in_progress_;
};

}  // namespace burnish
