// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/sim/actuation.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/sim/plant.hpp"
#include "burnish/sim/scene.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "estimate/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "mpc/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const ActuationStep*);
const Description& description_of(const ClosedLoopOptions*);
const Description& description_of(const Push*);
const Description& description_of(const MotorLoss*);
const Description& description_of(const UnknownPayload*);
const Description& description_of(const ImuFault*);
const Description& description_of(const Disturbances*);
const Description& description_of(const IdealPlantOptions*);
const Description& description_of(const PlantSnapshot*);
const Description& description_of(const SurfaceMotion*);
const Description& description_of(const SurfaceSpec*);
const Description& description_of(const TouchSpec*);
const Description& description_of(const SlipperyGround*);
const Description& description_of(const HoistSpec*);
const Description& description_of(const SceneSpec*);

}  // namespace burnish
