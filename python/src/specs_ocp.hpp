// Conversion of the types of the ocp layer between Python and C++. User-defined residuals hold
// Python functions.
#pragma once

#include "burnish/ocp/check.hpp"
#include "burnish/ocp/problem.hpp"
#include "callback.hpp"
#include "ocp/descriptions.gen.hpp"
#include "specs_contact.hpp"
#include "specs_derivatives.hpp"

namespace burnish::python {

/// Result of Problem.evaluate().
struct TrajectoryValues {
  Eigen::VectorXd costs;
  RowMatrix next_states;
  std::vector<Status> statuses;
  std::vector<int> terms;
};

/// Result of Problem.expand(): derivatives of a horizon.
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
