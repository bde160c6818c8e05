// Conversion of the types that tasks that press have in common, between Python and C++.
#pragma once

#include <pybind11/numpy.h>

#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "pressing/run_descriptions.hpp"
#include "specs_mpc.hpp"
#include "specs_report.hpp"

namespace burnish::python {

/// Array with the dimensions plans x rows x columns.
template <class T>
struct PlanCube {
  py::array_t<T> array;
};

/// burnish.pressing.PlanRecord: arrays of a burnish::PlanRecord. The comments of arrays state their
/// dimensions.
struct PlanArrays {
  Eigen::VectorXd time;            ///< plans
  std::vector<std::string> terms;  ///< names of the rows of `costs`
  RowMatrix costs;                 ///< terms x plans
  double step = 0.0;
  PlanCube<float> q = {};  ///< plans x knots x nq
  // Values at the first knot of each plan:
  RowMatrix x;                ///< plans x nx
  RowMatrix u;                ///< plans x nu
  PlanCube<double> K = {};    ///< plans x nu x ndx
  RowMatrix Vx;               ///< plans x ndx
  PlanCube<double> Vxx = {};  ///< plans x ndx x ndx
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
