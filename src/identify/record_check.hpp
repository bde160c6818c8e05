// A record looked through before anything is estimated from it: numbers, jumps, wrapped angles,
// outliers, encoders that stand still, and the limits of the robot.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// "q_<joint>" and "tau_<joint>", as files name the columns.
std::string q_column(const Model& model, int entry_of_q);
std::string tau_column(const Model& model, int entry_of_v);
/// Time of a sample, such as "3.21 s".
std::string time_text(const MotionRecord& record, Eigen::Index sample);

struct CheckedRecord {
  MotionRecord record;                ///< wrapped angles unwrapped, outliers bridged
  std::vector<std::string> warnings;  ///< sentences about what was mended
  std::vector<std::string> oddities;  ///< what is odd but may be right, phrases
  std::vector<int> constant_torques;  ///< entries of v whose torque never changes
};

/// Throws Error, naming column and time, for numbers that are not finite, an arm at rest, columns
/// that jump, torques that never change although the motion asks for a change, and an encoder that
/// stands still within a motion.
CheckedRecord checked_record(const Model& model, const MotionRecord& record);

/// What breaks the robot's limits of position, speed and torque, a phrase for each kind of limit
/// with the worst column, its time and the number of others; empty within all of them.
std::vector<std::string> beyond_limits(const Model& model, const MotionRecord& record);

}  // namespace burnish::identify_detail
