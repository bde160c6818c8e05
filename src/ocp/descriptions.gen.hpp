// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/ocp/check.hpp"
#include "burnish/ocp/input.hpp"
#include "burnish/ocp/node_view.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/ocp/problem_spec.hpp"
#include "burnish/ocp/residual.hpp"
#include "burnish/ocp/step_check.hpp"
#include "contact/descriptions.gen.hpp"
#include "derivatives/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const ProblemCheckOptions*);
const Description& description_of(const ProblemCheckRow*);
const Description& description_of(const ProblemReport*);
const Words& words_of(InputKind);
const Description& description_of(const InputSpec*);
const Description& description_of(const StateLayout*);
const Description& description_of(const Problem::QuasiStatic*);
const Description& description_of(const Penalty*);
const Words& words_of(Penalty::Kind);
const Description& description_of(const CostTerm*);
const Description& description_of(const Constraint*);
const Words& words_of(Integrator);
const Description& description_of(const TorqueModel*);
const Words& words_of(TorqueModel::Discretization);
const Description& description_of(const ActuationSpec*);
const Description& description_of(const Stage*);
const Description& description_of(const HorizonSegment*);
const Description& description_of(const ProblemSpec*);
const Description& description_of(const StepError*);
const Description& description_of(const StepReport*);

}  // namespace burnish

namespace burnish::residual {

const Description& description_of(const State*);
const Description& description_of(const Control*);
const Description& description_of(const JointPosition*);
const Description& description_of(const JointVelocity*);
const Description& description_of(const JointTorque*);
const Description& description_of(const JointTorqueRate*);
const Description& description_of(const FramePosition*);
const Description& description_of(const FrameDistance*);
const Description& description_of(const FrameRotation*);
const Description& description_of(const FrameInclination*);
const Description& description_of(const FrameHeight*);
const Description& description_of(const FramePlacement*);
const Description& description_of(const FrameVelocity*);
const Description& description_of(const ContactForce*);
const Description& description_of(const ContactForceRate*);
const Description& description_of(const FrictionCone*);
const Description& description_of(const CenterOfPressure*);
const Description& description_of(const CenterOfMass*);
const Description& description_of(const SupportMargin*);
const Description& description_of(const CentroidalMomentum*);

}  // namespace burnish::residual
