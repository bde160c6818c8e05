// Values of what tasks that press share, and their runs.
#pragma once

#include <pybind11/numpy.h>

#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "pressing/run_descriptions.hpp"
#include "specs_mpc.hpp"
#include "specs_report.hpp"

namespace burnish::python {

/// An array of plans x knots x nq.
struct PlanPostures {
  py::array_t<float> array;
};

/// burnish.pressing.PlanRecord: burnish::PlanRecord as arrays.
struct PlanArrays {
  Eigen::VectorXd time;            ///< plans
  std::vector<std::string> terms;  ///< of the costs
  RowMatrix costs;                 ///< terms x plans
  double step = 0.0;
  PlanPostures q = {};
};
PlanArrays arrays_of(const PlanRecord& record);
PlanRecord record_of(const PlanArrays& arrays);

template <>
struct SpecOf<PlanArrays> : AsDataclass<PlanArrays> {};

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
