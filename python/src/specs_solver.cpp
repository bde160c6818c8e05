#include "specs_solver.hpp"

namespace burnish::python {

namespace {

/// A callback that Python gave. It may answer nothing, which means to go on.
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

template <>
const EnumTable& AsEnum<StopReason>::table() {
  static const EnumTable words("burnish.solver", "StopReason",
                               {"converged", "max_iterations", "time_budget", "not_evaluated",
                                "not_positive_definite", "no_step", "callback"});
  return words;
}
template <>
const SpecTable& AsDataclass<Regularization>::table() {
  static const SpecTable fields =
      SpecTable("burnish.solver", "Regularization")
          .field("initial", &Regularization::initial)
          .field("smallest", &Regularization::smallest)
          .field("largest", &Regularization::largest)
          .field("factor", &Regularization::factor)
          .field("decrease_above", &Regularization::decrease_above)
          .field("increase_at_or_below", &Regularization::increase_at_or_below);
  return fields;
}
template <>
const SpecTable& AsDataclass<LineSearch>::table() {
  static const SpecTable fields =
      SpecTable("burnish.solver", "LineSearch")
          .field("halvings", &LineSearch::halvings)
          .field("sufficient_decrease", &LineSearch::sufficient_decrease)
          .field("allowed_increase", &LineSearch::allowed_increase)
          .field("merit_decrease", &LineSearch::merit_decrease)
          .field("merit_share", &LineSearch::merit_share)
          .field("rounding", &LineSearch::rounding);
  return fields;
}
template <>
const SpecTable& AsDataclass<DdpProgress>::table() {
  static const SpecTable fields =
      SpecTable("burnish.solver", "DdpProgress")
          .field("iteration", &DdpProgress::iteration)
          .field("cost", &DdpProgress::cost)
          .field("expected_improvement", &DdpProgress::expected_improvement)
          .field("largest_gap", &DdpProgress::largest_gap)
          .field("step_length", &DdpProgress::step_length)
          .field("regularization", &DdpProgress::regularization)
          .field("penalty", &DdpProgress::penalty)
          .field("feasible", &DdpProgress::feasible)
          .field("seconds", &DdpProgress::seconds);
  return fields;
}
template <>
const SpecTable& AsDataclass<DdpOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.solver", "DdpOptions")
                                      .field("update", &DdpOptions::update)
                                      .field("max_iterations", &DdpOptions::max_iterations)
                                      .field("time_budget", &DdpOptions::time_budget)
                                      .field("threads", &DdpOptions::threads)
                                      .field("pin_threads", &DdpOptions::pin_threads)
                                      .field("share_knots", &DdpOptions::share_knots)
                                      .field("segments", &DdpOptions::segments)
                                      .field("stop_tolerance", &DdpOptions::stop_tolerance)
                                      .field("gap_tolerance", &DdpOptions::gap_tolerance)
                                      .field("line_search", &DdpOptions::line_search)
                                      .field("regularization", &DdpOptions::regularization)
                                      .field("callback", &DdpOptions::callback);
  return fields;
}
template <>
const SpecTable& AsDataclass<PhaseTimes>::table() {
  static const SpecTable fields = SpecTable("burnish.solver", "PhaseTimes")
                                      .field("expand", &PhaseTimes::expand)
                                      .field("backward", &PhaseTimes::backward)
                                      .field("trial", &PhaseTimes::trial)
                                      .field("total", &PhaseTimes::total);
  return fields;
}
template <>
const SpecTable& AsDataclass<DdpSummary>::table() {
  static const SpecTable fields =
      SpecTable("burnish.solver", "DdpSummary")
          .field("reason", &DdpSummary::reason)
          .field("iterations", &DdpSummary::iterations)
          .field("cost", &DdpSummary::cost)
          .field("feasible", &DdpSummary::feasible)
          .field("expected_improvement", &DdpSummary::expected_improvement)
          .field("regularization", &DdpSummary::regularization)
          .field("largest_gap", &DdpSummary::largest_gap)
          .field("gap_knot", &DdpSummary::gap_knot)
          .field("gap_entry", &DdpSummary::gap_entry)
          .field("status", &DdpSummary::status)
          .field("knot", &DdpSummary::knot)
          .field("term", &DdpSummary::term)
          .field("row", &DdpSummary::row)
          .field("in_derivatives", &DdpSummary::in_derivatives)
          .field("control", &DdpSummary::control)
          .field("options", &DdpSummary::options)
          .field("seconds", &DdpSummary::seconds)
          .field("log", &DdpSummary::log);
  return fields;
}
template <>
const SpecTable& AsDataclass<CostReport::Entry>::table() {
  static const SpecTable fields = SpecTable("burnish.solver", "CostEntry")
                                      .field("name", &CostReport::Entry::name)
                                      .field("cost", &CostReport::Entry::cost);
  return fields;
}
template <>
const SpecTable& AsDataclass<CostReport::Knot>::table() {
  static const SpecTable fields = SpecTable("burnish.solver", "CostKnot")
                                      .field("name", &CostReport::Knot::name)
                                      .field("cost", &CostReport::Knot::cost)
                                      .field("terms", &CostReport::Knot::terms);
  return fields;
}
template <>
const SpecTable& AsDataclass<CostReport::Row>::table() {
  static const SpecTable fields = SpecTable("burnish.solver", "LimitedRow")
                                      .field("name", &CostReport::Row::name)
                                      .field("knot", &CostReport::Row::knot)
                                      .field("value", &CostReport::Row::value)
                                      .field("lower", &CostReport::Row::lower)
                                      .field("upper", &CostReport::Row::upper)
                                      .field("outside", &CostReport::Row::outside);
  return fields;
}
template <>
const SpecTable& AsDataclass<CostReport>::table() {
  static const SpecTable fields = SpecTable("burnish.solver", "CostReport")
                                      .field("total", &CostReport::total)
                                      .field("terms", &CostReport::terms)
                                      .field("knots", &CostReport::knots)
                                      .field("rows", &CostReport::rows);
  return fields;
}
template <>
const SpecTable& AsDataclass<NamedMatrix>::table() {
  static const SpecTable fields = SpecTable("burnish.solver", "NamedMatrix")
                                      .field("rows", &NamedMatrix::rows)
                                      .field("columns", &NamedMatrix::columns)
                                      .field("values", &NamedMatrix::values);
  return fields;
}

}  // namespace burnish::python
