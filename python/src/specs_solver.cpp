#include "specs_solver.hpp"

namespace burnish::python {

namespace {

/// Callback from Python. If it returns None, the solver continues.
struct PythonCallback {
  Kept function;

  bool operator()(const DdpProgress& progress) const {
    const py::gil_scoped_acquire lock;
    const py::object answer = function.get()(progress);
    if (answer.is_none()) return true;
    const int truth = PyObject_IsTrue(answer.ptr());
    if (truth < 0) throw py::error_already_set();
    return truth != 0;
  }
};

}  // namespace

bool load_callback(py::handle from, DdpCallback& callback) {
  if (from.is_none()) {
    callback = nullptr;
  } else if (PyCallable_Check(from.ptr()) != 0) {
    callback = PythonCallback{Kept(py::reinterpret_borrow<py::object>(from))};
  } else {
    return false;
  }
  return true;
}

py::object make_callback(const DdpCallback& callback) {
  if (!callback) return py::none();
  if (const auto* ours = callback.target<PythonCallback>()) return ours->function.get();
  return py::cpp_function(callback);
}

}  // namespace burnish::python
