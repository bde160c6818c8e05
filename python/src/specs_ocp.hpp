// Values of the ocp layer. Residuals of the user's own hold functions of Python's.
#pragma once

#include "burnish/ocp/check.hpp"
#include "burnish/ocp/problem.hpp"
#include "callback.hpp"
#include "specs_contact.hpp"
#include "specs_derivatives.hpp"

namespace burnish::python {

/// What Problem.evaluate answers.
struct TrajectoryValues {
  Eigen::VectorXd costs;
  RowMatrix next_states;
  std::vector<Status> statuses;
  std::vector<int> terms;
};

/// First and second order of a horizon, as Problem.expand answers.
struct TrajectoryExpansion {
  Eigen::VectorXd costs;
  RowMatrix next_states, gradients;
  std::vector<Status> statuses;
  std::vector<int> terms;
  py::array_t<double> hessians, dynamics;
};

template <>
struct EnumOf<Penalty::Kind> : AsEnum<Penalty::Kind> {};
template <>
struct EnumOf<Integrator> : AsEnum<Integrator> {};
template <>
struct EnumOf<TorqueModel::Discretization> : AsEnum<TorqueModel::Discretization> {};
template <>
struct SpecOf<Penalty> : AsDataclass<Penalty> {};
template <>
struct SpecOf<residual::State> : AsDataclass<residual::State> {};
template <>
struct SpecOf<residual::Control> : AsDataclass<residual::Control> {};
template <>
struct SpecOf<residual::JointPosition> : AsDataclass<residual::JointPosition> {};
template <>
struct SpecOf<residual::JointVelocity> : AsDataclass<residual::JointVelocity> {};
template <>
struct SpecOf<residual::JointTorque> : AsDataclass<residual::JointTorque> {};
template <>
struct SpecOf<residual::FramePosition> : AsDataclass<residual::FramePosition> {};
template <>
struct SpecOf<residual::FrameRotation> : AsDataclass<residual::FrameRotation> {};
template <>
struct SpecOf<residual::FramePlacement> : AsDataclass<residual::FramePlacement> {};
template <>
struct SpecOf<residual::FrameVelocity> : AsDataclass<residual::FrameVelocity> {};
template <>
struct SpecOf<residual::ContactForce> : AsDataclass<residual::ContactForce> {};
template <>
struct SpecOf<residual::FrictionCone> : AsDataclass<residual::FrictionCone> {};
template <>
struct SpecOf<residual::CenterOfPressure> : AsDataclass<residual::CenterOfPressure> {};
template <>
struct SpecOf<residual::CenterOfMass> : AsDataclass<residual::CenterOfMass> {};
template <>
struct SpecOf<residual::CentroidalMomentum> : AsDataclass<residual::CentroidalMomentum> {};
template <>
struct SpecOf<CostTerm> : AsDataclass<CostTerm> {};
template <>
struct SpecOf<Constraint> : AsDataclass<Constraint> {};
template <>
struct SpecOf<TorqueModel> : AsDataclass<TorqueModel> {};
template <>
struct SpecOf<ActuationSpec> : AsDataclass<ActuationSpec> {};
template <>
struct SpecOf<Stage> : AsDataclass<Stage> {};
template <>
struct SpecOf<HorizonSegment> : AsDataclass<HorizonSegment> {};
template <>
struct SpecOf<ProblemSpec> : AsDataclass<ProblemSpec> {};
template <>
struct SpecOf<StateLayout> : AsDataclass<StateLayout> {};
template <>
struct SpecOf<Problem::QuasiStatic> : AsDataclass<Problem::QuasiStatic> {};
template <>
struct SpecOf<ProblemCheckOptions> : AsDataclass<ProblemCheckOptions> {};
template <>
struct SpecOf<ProblemCheckRow> : AsDataclass<ProblemCheckRow> {};
template <>
struct SpecOf<ProblemReport> : AsDataclass<ProblemReport> {};
template <>
struct SpecOf<TrajectoryValues> : AsDataclass<TrajectoryValues> {};
template <>
struct SpecOf<TrajectoryExpansion> : AsDataclass<TrajectoryExpansion> {};
template <>
struct SpecOf<residual::Custom> : AsDataclass<residual::Custom> {};

}  // namespace burnish::python
