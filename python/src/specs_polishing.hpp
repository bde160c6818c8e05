// Values of the polishing task, its runs and its experiments.
#pragma once

#include "burnish/tasks/polishing/posture.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/experiments/experiment.hpp"
#include "specs_model.hpp"
#include "specs_mpc.hpp"
#include "specs_report.hpp"
#include "specs_sim.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

/// An array of plans x knots x nq.
struct PlanPostures {
  py::array_t<float> array;
};

/// burnish.polishing.PlanRecord: polishing::PlanRecord as arrays.
struct PlanArrays {
  Eigen::VectorXd time;            ///< plans
  std::vector<std::string> terms;  ///< of the costs
  RowMatrix costs;                 ///< terms x plans
  double step = 0.0;
  PlanPostures q = {};
};

/// burnish.polishing.Experiment: what a polishing::Experiment says of itself.
struct NamedExperiment {
  std::string name, summary;
};

template <>
struct EnumOf<polishing::ReachProblem> : AsEnum<polishing::ReachProblem> {};
template <>
struct EnumOf<polishing::ControllerKind> : AsEnum<polishing::ControllerKind> {};
template <>
struct EnumOf<polishing::PlantKind> : AsEnum<polishing::PlantKind> {};
template <>
struct SpecOf<polishing::VerdictFigures> : AsDataclass<polishing::VerdictFigures> {};
template <>
struct SpecOf<polishing::NamedSurface> : AsDataclass<polishing::NamedSurface> {};
template <>
struct SpecOf<polishing::Setting> : AsDataclass<polishing::Setting> {};
template <>
struct SpecOf<polishing::ReachOptions> : AsDataclass<polishing::ReachOptions> {};
template <>
struct SpecOf<polishing::ReachReport> : AsDataclass<polishing::ReachReport> {};
template <>
struct SpecOf<polishing::PostureOptions> : AsDataclass<polishing::PostureOptions> {};
template <>
struct SpecOf<polishing::FoundPosture> : AsDataclass<polishing::FoundPosture> {};
template <>
struct SpecOf<polishing::RunSpec> : AsDataclass<polishing::RunSpec> {};
template <>
struct SpecOf<polishing::TickTimes> : AsDataclass<polishing::TickTimes> {};
template <>
struct SpecOf<polishing::ExperimentSpec> : AsDataclass<polishing::ExperimentSpec> {};
template <>
struct SpecOf<polishing::ResultColumn> : AsDataclass<polishing::ResultColumn> {};
template <>
struct SpecOf<polishing::ResultTable> : AsDataclass<polishing::ResultTable> {};
template <>
struct SpecOf<polishing::Figure> : AsDataclass<polishing::Figure> {};
template <>
struct SpecOf<polishing::NamedTask> : AsDataclass<polishing::NamedTask> {};
template <>
struct SpecOf<polishing::ExperimentReport> : AsDataclass<polishing::ExperimentReport> {};
template <>
struct SpecOf<PlanArrays> : AsDataclass<PlanArrays> {};
template <>
struct SpecOf<NamedExperiment> : AsDataclass<NamedExperiment> {};

}  // namespace burnish::python

namespace pybind11::detail {

template <>
struct type_caster<burnish::python::PlanPostures> {
  PYBIND11_TYPE_CASTER(burnish::python::PlanPostures, const_name("numpy.ndarray[numpy.float32]"));
  bool load(handle from, bool) {
    value.array = array_t<float, array::c_style | array::forcecast>::ensure(from);
    return value.array && value.array.ndim() == 3;
  }
  static handle cast(const burnish::python::PlanPostures& from, return_value_policy, handle) {
    return from.array.ndim() == 3 ? from.array.inc_ref()
                                  : array_t<float>(std::vector<ssize_t>{0, 0, 0}).release();
  }
};

}  // namespace pybind11::detail
