// Values of the ocp layer. Residuals of the user's own hold functions of Python's.
#pragma once

#include "burnish/ocp/check.hpp"
#include "burnish/ocp/problem.hpp"
#include "callback.hpp"
#include "ocp/descriptions.gen.hpp"
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
struct SpecOf<TrajectoryValues> : AsDataclass<TrajectoryValues> {};
template <>
struct SpecOf<TrajectoryExpansion> : AsDataclass<TrajectoryExpansion> {};
template <>
struct SpecOf<residual::Custom> : AsDataclass<residual::Custom> {};

}  // namespace burnish::python
