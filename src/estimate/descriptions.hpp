// What the layer's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/estimate/base_estimator.hpp"
#include "burnish/estimate/foot_contacts.hpp"
#include "burnish/estimate/imu.hpp"

namespace burnish {

const Words& words_of(FootKind);
const Description& description_of(const ImuReading*);
const Description& description_of(const FootSpec*);
const Description& description_of(const UnitWatchOptions*);
const Description& description_of(const BaseEstimatorOptions*);
const Description& description_of(const EstimatorInnovation*);
const Description& description_of(const FootContactOptions*);

}  // namespace burnish
