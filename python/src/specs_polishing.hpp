// Conversion of the types of the polishing task, its runs and experiments between Python and C++.
#pragma once

#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/descriptions.gen.hpp"
#include "polishing/experiments/experiment.hpp"
#include "polishing/figures.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

/// burnish.polishing.Experiment: name and summary of a polishing::Experiment.
struct NamedExperiment {
  std::string name, summary;
};

template <>
struct SpecOf<NamedExperiment> : AsDataclass<NamedExperiment> {};

}  // namespace burnish::python
