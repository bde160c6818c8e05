// Conversion of the types that tasks that press have in common, between Python and C++.
#pragma once

#include <pybind11/numpy.h>

#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "pressing/figures.hpp"
#include "specs_mpc.hpp"
#include "specs_report.hpp"

namespace burnish::python {

/// Array with the dimensions plans x rows x columns.
template <class T>
struct PlanCube {
  py::array_t<T> array;
};

/// burnish.pressing.PlanRecord: arrays of a burnish::PlanRecord.
struct PlanArrays {
  Eigen::VectorXd time;            ///< Times of the first knots, one per plan [s]
  std::vector<std::string> terms;  ///< Names of the cost terms, which are the rows of `costs`
  RowMatrix costs;                 ///< Costs, terms x plans
  double step = 0.0;
  PlanCube<float> q = {};  ///< Configurations, plans x knots x nq
  // Values at the first knot of each plan:
  RowMatrix x;                ///< States, plans x nx
  RowMatrix u;                ///< Controls, plans x nu
  PlanCube<double> K = {};    ///< Feedback gains, plans x nu x ndx
  RowMatrix Vx;               ///< Gradients of the cost-to-go, plans x ndx
  PlanCube<double> Vxx = {};  ///< Hessians of the cost-to-go, plans x ndx x ndx
};
PlanArrays arrays_of(const PlanRecord& record);
PlanRecord record_of(const PlanArrays& arrays);

template <>
struct SpecOf<PlanArrays> : AsDataclass<PlanArrays> {};

}  // namespace burnish::python

namespace pybind11::detail {

template <class T>
struct type_caster<burnish::python::PlanCube<T>> {
  PYBIND11_TYPE_CASTER(burnish::python::PlanCube<T>, const_name("numpy.ndarray"));
  bool load(handle from, bool) {
    value.array = array_t<T, array::c_style | array::forcecast>::ensure(from);
    return value.array && value.array.ndim() == 3;
  }
  static handle cast(const burnish::python::PlanCube<T>& from, return_value_policy, handle) {
    return from.array.ndim() == 3 ? from.array.inc_ref()
                                  : array_t<T>(std::vector<ssize_t>{0, 0, 0}).release();
  }
};

}  // namespace pybind11::detail
