#include "arrays.hpp"

#include "burnish/base/error.hpp"

namespace burnish::python {

py::array_t<double> copied(const VectorView& view) {
  return py::array_t<double>(static_cast<py::ssize_t>(view.size()), view.data());
}

py::array_t<double> copied(const MatrixView& view) {
  return py::array_t<double>(
      {static_cast<py::ssize_t>(view.rows()), static_cast<py::ssize_t>(view.cols())}, view.data());
}

py::array_t<double> view_of(const double* data, std::vector<py::ssize_t> sizes,
                            std::vector<py::ssize_t> strides, py::handle owner) {
  py::array_t<double> array(std::move(sizes), std::move(strides), data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

bool load_placement(py::handle from, Eigen::Isometry3d& placement) {
  py::detail::make_caster<Eigen::Matrix4d> caster;
  if (!caster.load(from, true)) return false;
  const Eigen::Matrix4d& matrix = py::detail::cast_op<Eigen::Matrix4d&>(caster);
  const Eigen::Matrix3d R = matrix.topLeftCorner<3, 3>();
  constexpr double tolerance = 1e-6;
  if (!(R.transpose() * R).isIdentity(tolerance) || !(R.determinant() > 0.0) ||
      !matrix.row(3).isApprox(Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0), tolerance))
    throw Error(
        "placement: the 4 x 4 array is not a placement; wanted a rotation matrix and a position "
        "above "
        "the row 0, 0, 0, 1");
  placement.matrix() = matrix;
  return true;
}

}  // namespace burnish::python
