#include "specs_base.hpp"

namespace burnish::python {

Numbers numbers_of(const py::object& answer) {
  return answer.is_none() ? py::reinterpret_steal<Numbers>(py::handle()) : Numbers::ensure(answer);
}

std::string what_came(const Numbers& numbers) {
  return numbers ? "an array of shape " + std::string(py::str(numbers.attr("shape")))
                 : "no numbers";
}

namespace {

/// Signal whose values a Python function of time computes.
struct PythonSignal {
  Kept function;

  void operator()(double time, Eigen::Ref<Eigen::VectorXd> out) const {
    const py::gil_scoped_acquire lock;
    const Numbers numbers = numbers_of(function.get()(time));
    if (!numbers || numbers.ndim() > 1 || numbers.size() != out.size())
      throw Error("signal: the function of time gave " + what_came(numbers) + " at " +
                  std::string(py::str(py::float_(time))) + " s; wanted " +
                  std::to_string(out.size()) + " numbers");
    out = Eigen::Map<const Eigen::VectorXd>(numbers.data(), out.size());
  }
};

const PythonClass over_time_class("burnish._signal", "OverTime");

Signal signal_over_time(int size, const py::object& function) {
  return Signal::over_time(size, PythonSignal{Kept(function)});
}

}  // namespace

bool load_signal(py::handle from, Signal& signal) {
  if (from.is_none()) {
    signal = {};
    return true;
  }
  if (py::isinstance(from, over_time_class.get())) {
    const py::object function = from.attr("function");
    signal = py::isinstance<SignalFunction>(function)
                 ? py::cast<const SignalFunction&>(function).signal
                 : signal_over_time(py::cast<int>(from.attr("size")), function);
    return true;
  }
  const auto object = py::reinterpret_borrow<py::object>(from);
  if (py::isinstance<SignalFunction>(from)) {
    signal = py::cast<const SignalFunction&>(from).signal;
    return true;
  }
  if (PyCallable_Check(from.ptr()) != 0) {
    const Numbers first = numbers_of(object(0.0));
    if (!first || first.ndim() > 1)
      throw Error("signal: the function of time gave " + what_came(first) +
                  " at 0 s; wanted numbers");
    signal = signal_over_time(static_cast<int>(first.size()), object);
    return true;
  }
  const Numbers numbers = Numbers::ensure(from);
  if (!numbers || numbers.ndim() > 1) return false;
  signal = Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(numbers.data(), numbers.size()));
  return true;
}

py::object make_signal(const Signal& signal) {
  if (signal.empty()) return py::none();
  if (signal.is_constant()) {
    Eigen::VectorXd value(signal.size());
    signal.at(0.0, value);
    return py::cast(value);
  }
  const auto* ours = signal.function().target<PythonSignal>();
  const py::object function =
      ours != nullptr ? ours->function.get() : py::cast(SignalFunction{signal});
  return py::reinterpret_borrow<py::object>(over_time_class.get())(signal.size(), function);
}

}  // namespace burnish::python
