// The terms of a problem that say what a support bears: its friction cone and its pressure.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// A term whose target is the coefficient of friction under a support.
struct GroundTerm {
  int term;         ///< of its stage, costs first
  int support;      ///< of supports_of()
  double friction;  ///< as the specification has it
};

/// Per stage of the problem.
std::vector<std::vector<GroundTerm>> ground_terms(const MpcSpec& spec);

/// What plans reckon with under a support, from the first terms that say so.
struct GroundFigures {
  double friction;        ///< of its cone; infinite: none
  double half_x, half_y;  ///< m, of its sole; 0: none with friction
};
GroundFigures ground_figures(const ProblemSpec& problem, const std::string& contact);

}  // namespace burnish
