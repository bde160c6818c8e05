#include "specs_ocp.hpp"

#include "node_handle.hpp"

namespace burnish::python {

namespace {

/// Function of a residual, implemented in Python.
struct PythonResidual {
  Kept function;
  std::shared_ptr<const residual::Custom> names;  ///< Name, frames and contacts of the residual

  /// Must be called with the GIL.
  Numbers call(const NodeView& at, bool with_derivatives) const {
    const NodeLease lease(at, *names, with_derivatives);
    return numbers_of(function.get()(lease.object()));
  }
  [[noreturn]] void refuse(const char* what, const Numbers& numbers,
                           const std::string& wanted_shape) const {
    throw Error("residual '" + names->name + "': " + what + " gave " + what_came(numbers) +
                "; wanted " + wanted_shape);
  }
};

struct PythonValue : PythonResidual {
  void operator()(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    const py::gil_scoped_acquire lock;
    const Numbers numbers = call(at, false);
    const bool fits = numbers && numbers.size() == out.size() && numbers.ndim() <= 1;
    if (!fits) refuse("value", numbers, "(" + std::to_string(out.size()) + ",)");
    out = Eigen::Map<const Eigen::VectorXd>(numbers.data(), out.size());
  }
};

struct PythonJacobian : PythonResidual {
  void operator()(const NodeView& at, Eigen::Ref<RowMatrix> out) const {
    const py::gil_scoped_acquire lock;
    const Numbers numbers = call(at, true);
    const bool row = numbers && numbers.ndim() == 1 && out.rows() == 1;
    const bool fits = numbers && numbers.size() == out.size() &&
                      (row || (numbers.ndim() == 2 && numbers.shape(0) == out.rows()));
    if (!fits)
      refuse("jacobian", numbers,
             "(" + std::to_string(out.rows()) + ", " + std::to_string(out.cols()) + ")");
    out = Eigen::Map<const RowMatrix>(numbers.data(), out.rows(), out.cols());
  }
};

std::string wanted_function() { return "a function of a NodeView, or None"; }

/// Converts a function of a residual for Python: returns the original Python function, or a wrapper
/// of a C++ function. `empty`: makes the array to which a C++ function writes.
template <class Given, class Function, class Empty>
py::object function_for_python(const Function& function, Empty empty) {
  if (!function) return py::none();
  if (const auto* ours = function.template target<Given>()) return ours->function.get();
  return py::cpp_function([function, empty](const NodeHandle& at) {
    auto out = empty(at);
    function(at.view(), out);
    return out;
  });
}

/// Sets `function` to a Given that calls the Python function `value`, or to null for None.
template <class Given, class Function>
bool function_from_python(const residual::Custom& custom, py::handle value, Function& function) {
  if (value.is_none()) {
    function = nullptr;
  } else if (PyCallable_Check(value.ptr()) != 0) {
    auto names = std::make_shared<residual::Custom>();
    names->name = custom.name;
    names->frames = custom.frames;
    names->contacts = custom.contacts;
    function = Given{Kept(py::reinterpret_borrow<py::object>(value)), names};
  } else {
    return false;
  }
  return true;
}

}  // namespace

template <>
const SpecTable& AsDataclass<residual::Custom>::table() {
  using residual::Custom;
  static const SpecTable fields =
      SpecTable("burnish.residual", "Custom")
          .field("name", &Custom::name)
          .field("rows", &Custom::rows)
          .field("frames", &Custom::frames)
          .field("contacts", &Custom::contacts)
          .field<Custom>(
              "value", wanted_function,
              [](const Custom& custom) {
                return function_for_python<PythonValue>(
                    custom.value, [rows = custom.rows](const NodeHandle& /*at*/) {
                      return Eigen::VectorXd(Eigen::VectorXd::Zero(rows));
                    });
              },
              [](Custom& custom, py::handle value) {
                return function_from_python<PythonValue>(custom, value, custom.value);
              })
          .field<Custom>(
              "jacobian", wanted_function,
              [](const Custom& custom) {
                return function_for_python<PythonJacobian>(
                    custom.jacobian, [rows = custom.rows](const NodeHandle& at) {
                      return RowMatrix(RowMatrix::Zero(rows, at.view().layout().nz()));
                    });
              },
              [](Custom& custom, py::handle value) {
                return function_from_python<PythonJacobian>(custom, value, custom.jacobian);
              });
  return fields;
}
template <>
const SpecTable& AsDataclass<TrajectoryValues>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "TrajectoryValues")
                                      .field("costs", &TrajectoryValues::costs)
                                      .field("next_states", &TrajectoryValues::next_states)
                                      .field("statuses", &TrajectoryValues::statuses)
                                      .field("terms", &TrajectoryValues::terms);
  return fields;
}

template <>
const SpecTable& AsDataclass<TrajectoryExpansion>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "TrajectoryExpansion")
                                      .field("costs", &TrajectoryExpansion::costs)
                                      .field("next_states", &TrajectoryExpansion::next_states)
                                      .field("statuses", &TrajectoryExpansion::statuses)
                                      .field("terms", &TrajectoryExpansion::terms)
                                      .field("gradients", &TrajectoryExpansion::gradients)
                                      .field("hessians", &TrajectoryExpansion::hessians)
                                      .field("dynamics", &TrajectoryExpansion::dynamics);
  return fields;
}

}  // namespace burnish::python
