// C++ values that hold Python functions. Any thread can copy, call and delete these values.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <memory>
#include <utility>

namespace burnish::python {

namespace py = pybind11;

/// Python object that can be copied and deleted without the GIL.
class Kept {
 public:
  /// Must be called with the GIL.
  explicit Kept(py::object object)
      : object_(new py::object(std::move(object)), [](const py::object* kept) {
          const py::gil_scoped_acquire lock;
          delete kept;
        }) {}
  /// Must be used with the GIL.
  const py::object& get() const { return *object_; }

 private:
  std::shared_ptr<const py::object> object_;
};

/// Handles signals such as Ctrl-C during a long call. Throws the exception of a Python signal
/// handler.
inline void let_signals_through() {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// Periodic check for signals in the main thread, which receives the signals. The period is long
/// enough that fast solves do not wait for the GIL.
class SignalWatch {
 public:
  /// Must be called with the GIL.
  void begin() {
    const py::module_ threading = py::module_::import("threading");
    on_main_thread_ = threading.attr("current_thread")().is(threading.attr("main_thread")());
    last_ = Clock::now();
  }
  void look() {
    constexpr std::chrono::milliseconds pause(50);
    if (!on_main_thread_ || Clock::now() - last_ < pause) return;
    let_signals_through();
    last_ = Clock::now();
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool on_main_thread_ = false;
  Clock::time_point last_ = {};
};

}  // namespace burnish::python
