// NumPy arrays and Eigen: placements as 4 x 4 arrays, results as copies or as views that say whose
// memory they are.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>

#include <Eigen/Geometry>

#include "burnish/base/views.hpp"

namespace burnish::python {

namespace py = pybind11;

/// A copy, Python's own.
py::array_t<double> copied(const VectorView& view);
py::array_t<double> copied(const MatrixView& view);

/// An array on memory that `owner` keeps alive; nobody can write to it. Sizes and strides (bytes),
/// one per dimension.
py::array_t<double> view_of(const double* data, std::vector<py::ssize_t> sizes,
                            std::vector<py::ssize_t> strides, py::handle owner);

/// Reads a 4 x 4 homogeneous matrix. False for another shape; throws Error if its rotation is none.
bool load_placement(py::handle from, Eigen::Isometry3d& placement);

}  // namespace burnish::python

namespace pybind11::detail {

template <>
struct type_caster<Eigen::Isometry3d> {
  PYBIND11_TYPE_CASTER(Eigen::Isometry3d, const_name("numpy.ndarray[numpy.float64[4, 4]]"));
  bool load(handle from, bool) { return burnish::python::load_placement(from, value); }
  static handle cast(const Eigen::Isometry3d& from, return_value_policy, handle) {
    return pybind11::cast(Eigen::Matrix4d(from.matrix())).release();
  }
};

}  // namespace pybind11::detail
