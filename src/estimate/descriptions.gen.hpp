// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/estimate/base_estimator.hpp"
#include "burnish/estimate/foot_contacts.hpp"
#include "burnish/estimate/friction_estimate.hpp"
#include "burnish/estimate/imu.hpp"
#include "burnish/estimate/measurement.hpp"
#include "burnish/estimate/model_error.hpp"
#include "burnish/estimate/slip.hpp"
#include "burnish/estimate/surface_estimate.hpp"
#include "contact/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"

namespace burnish {

const Words& words_of(FootKind);
const Description& description_of(const FootSpec*);
const Description& description_of(const UnitWatchOptions*);
const Description& description_of(const BaseEstimatorOptions*);
const Description& description_of(const EstimatorInnovation*);
const Description& description_of(const FootContactOptions*);
const Description& description_of(const FrictionEstimateOptions*);
const Description& description_of(const ImuReading*);
const Words& words_of(WrenchSensor);
const Description& description_of(const TouchSensor*);
const Description& description_of(const Measurement*);
const Words& words_of(ModelErrorKind);
const Description& description_of(const ModelErrorOptions*);
const Description& description_of(const SlipOptions*);
const Description& description_of(const SurfaceEstimateOptions*);

}  // namespace burnish
