// Bindings of placements of frames.
#include "bind.hpp"
#include "burnish/dynamics/placement.hpp"
#include "specs_contact.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* frame_placement_doc = R"(Returns the placement of a frame in the world.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.
frame : str
    Name of a frame of the model, or "world".

Returns
-------
ndarray, shape (4, 4)

Raises
------
Error
    If q is invalid, or the frame is unknown; the message has the nearest name.)";

constexpr const char* frame_placements_doc =
    R"(Returns the placements of all frames in the world, in the order of model.frames.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.

Returns
-------
ndarray, shape (frames, 4, 4)

Raises
------
Error
    If q is invalid.)";

/// Array of placements, shape (frames, 4, 4).
py::array_t<double> stacked(const std::vector<Eigen::Isometry3d>& placements) {
  py::array_t<double> result(
      {static_cast<py::ssize_t>(placements.size()), py::ssize_t{4}, py::ssize_t{4}});
  double* out = result.mutable_data();
  for (const Eigen::Isometry3d& placement : placements) {
    Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(out);
    matrix = placement.matrix();
    out += matrix.size();
  }
  return result;
}

}  // namespace

void bind_dynamics(py::module_& m) {
  m.def(
      "frame_placement",
      [](const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q, const std::string& frame) {
        return frame_placement(model, q, frame);
      },
      py::arg("model"), py::arg("q"), py::arg("frame"), frame_placement_doc);
  m.def(
      "frame_placements",
      [](const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q) {
        return stacked(frame_placements(model, q));
      },
      py::arg("model"), py::arg("q"), frame_placements_doc);
}

}  // namespace burnish::python
