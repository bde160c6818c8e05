// Checks of a record before the estimation: numbers, jumps, wrapped angles, outliers, frozen
// encoders, and the limits of the robot.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// Return the column names of files, "q_<joint>" and "tau_<joint>".
std::string q_column(const Model& model, int entry_of_q);
std::string tau_column(const Model& model, int entry_of_v);
/// Returns the time of a sample, such as "3.21 s".
std::string time_text(const MotionRecord& record, Eigen::Index sample);

struct CheckedRecord {
  MotionRecord record;  ///< Record with wrapped angles unwrapped and outliers interpolated
  std::vector<std::string> warnings;  ///< Sentences about repairs
  std::vector<std::string> oddities;  ///< Phrases about unusual values that may be right
  std::vector<int> constant_torques;  ///< Entries of v whose torque never changes
};

/// Checks and repairs a record. Throws Error with column and time for numbers that are not finite,
/// an arm at rest, columns that jump, torques that never change although the arm moves, and
/// encoders that freeze during a motion.
CheckedRecord checked_record(const Model& model, const MotionRecord& record);

/// Returns a phrase per kind of limit (position, speed, torque) that the record exceeds, with the
/// worst column, its time and the number of other columns. Empty if no limit is exceeded.
std::vector<std::string> beyond_limits(const Model& model, const MotionRecord& record);

}  // namespace burnish::identify_detail
