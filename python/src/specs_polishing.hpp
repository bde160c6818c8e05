// Values of the polishing task, its runs and its experiments.
#pragma once

#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/experiments/experiment.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

/// burnish.polishing.Experiment: what a polishing::Experiment says of itself.
struct NamedExperiment {
  std::string name, summary;
};

template <>
struct EnumOf<polishing::ControllerKind> : AsEnum<polishing::ControllerKind> {};
template <>
struct SpecOf<polishing::VerdictFigures> : AsDataclass<polishing::VerdictFigures> {};
template <>
struct SpecOf<polishing::NamedSurface> : AsDataclass<polishing::NamedSurface> {};
template <>
struct SpecOf<polishing::Setting> : AsDataclass<polishing::Setting> {};
template <>
struct SpecOf<polishing::RunSpec> : AsDataclass<polishing::RunSpec> {};
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
struct SpecOf<NamedExperiment> : AsDataclass<NamedExperiment> {};

}  // namespace burnish::python
