// Resampling of records with uneven times.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// Sets the sampling period of the record. Resamples the record, and adds a warning to it, if
/// `time` [s] is uneven by more than 1 % of a period or if samples are missing. Resampling
/// interpolates by cubics through four samples. Throws Error if times do not increase, if a gap is
/// longer than 30 ms (or 3 periods, if that is more), or if more than 5 % of all samples are
/// missing.
void make_even(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& time,
               MotionRecord& record);

}  // namespace burnish::identify_detail
