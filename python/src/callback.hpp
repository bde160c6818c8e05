// Python functions inside C++ values: copied, called and dropped by any thread.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
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

/// Looks for Ctrl-C now and then: on the main thread, which alone hears it, and rarely enough that
/// a fast solve never waits for the interpreter.
class SignalWatch {
 public:
  /// Under the interpreter's lock.
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
