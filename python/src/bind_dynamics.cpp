// Where frames are, and what their motions are written in.
#include "bind.hpp"
#include "burnish/dynamics/placement.hpp"
#include "specs_contact.hpp"

namespace burnish::python {

namespace {

/// (frames, 4, 4).
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
      py::arg("model"), py::arg("q"), py::arg("frame"),
      "Placement (4, 4) in the world of a frame at q (nq,); 'world' is always known. Raises Error "
      "with the nearest known name, and for a bad q.");
  m.def(
      "frame_placements",
      [](const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q) {
        return stacked(frame_placements(model, q));
      },
      py::arg("model"), py::arg("q"),
      "Placements (frames, 4, 4) in the world of all frames of the model at q (nq,), in the order "
      "of model.frames. Raises Error for a bad q.");
}

}  // namespace burnish::python
