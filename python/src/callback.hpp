// Python functions inside C++ values: copied, called and dropped by any thread.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <utility>

namespace burnish::python {

namespace py = pybind11;

/// An object of Python's that C++ may copy and drop without the interpreter's lock.
class Kept {
 public:
  /// Under the interpreter's lock.
  explicit Kept(py::object object)
      : object_(new py::object(std::move(object)), [](const py::object* kept) {
          const py::gil_scoped_acquire lock;
          delete kept;
        }) {}
  /// To be used under the interpreter's lock.
  const py::object& get() const { return *object_; }

 private:
  std::shared_ptr<const py::object> object_;
};

/// Lets Ctrl-C through a long call: throws what a signal handler of Python's raised.
inline void let_signals_through() {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace burnish::python
