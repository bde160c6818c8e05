// Records whose times are uneven, brought to even times.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// Sets the record's period, and resamples it where `time` [s] is uneven by more than 1 % of a
/// period or samples are missing; the record's warnings say so. Between samples values are cubics
/// through four of them. Throws Error for times that do not increase, for gaps longer than 30 ms
/// (or 3 samples), and where more than 5 % of all samples are missing.
void make_even(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& time,
               MotionRecord& record);

}  // namespace burnish::identify_detail
