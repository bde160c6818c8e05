// Conversion between NumPy and Eigen: placements as 4 x 4 arrays, results as copies or views.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>

#include <Eigen/Geometry>

#include "burnish/base/views.hpp"

namespace burnish::python {

namespace py = pybind11;

/// Returns a copy in memory that Python owns.
py::array_t<double> copied(const VectorView& view);
py::array_t<double> copied(const MatrixView& view);

/// Returns a read-only view of memory that `owner` keeps alive. `sizes` and `strides` [bytes] have
/// one entry per dimension.
py::array_t<double> view_of(const double* data, std::vector<py::ssize_t> sizes,
                            std::vector<py::ssize_t> strides, py::handle owner);

/// Reads a 4 x 4 homogeneous matrix. Returns false for another shape. Throws Error for an invalid
/// rotation or last row.
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
