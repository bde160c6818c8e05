// Descriptions of the figures of a run, generated from the table in report/figures.hpp.
#pragma once

#include "burnish/report/standing_figures.hpp"
#include "report/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const SolverFigures*);
const Description& description_of(const Metrics*);
const Description& description_of(const StandingFigures*);

}  // namespace burnish
