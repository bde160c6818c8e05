// Bindings of the inputs of a Problem.
#include "base/sentence.hpp"
#include "bind_derivatives.hpp"
#include "bind_ocp.hpp"
#include "specs_model.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {
namespace {

constexpr const char* problem_input_doc =
    R"(Sets the value of a scalar, vector or rotation input at all knots.

Where the input is used, the value replaces InputSpec.value and targets that were set at single
knots.

Parameters
----------
input : str or int
    Name or index.
value : array_like
    Number, vector, or quaternion x, y, z, w.
decaying : array_like, optional
    Part that decays over the horizon, of the same size. At the time t of a knot, the input is
    value + exp(-(t - t_0) / decay_time) decaying, where t_0 is the time of knot 0.
decay_time : float, optional
    Time constant of the decaying part [s], > 0.

Raises
------
Error
    If the input does not exist, is of another kind, or has another number of entries.
EvaluationError
    If the value has a NaN, is a negative coefficient or ratio of friction, or is a quaternion that
    is not normalized; nothing changes.)";

constexpr const char* problem_surface_input_doc =
    R"(Sets a surface input, at all knots.

Parameters
----------
input : str or int
    Name or index.
surface : Quadric
    Surface, in the axes in which the users of the input state their surfaces and points.
depth : float
    Depth by which the surface yields along its normal [m], at least 0.)";

constexpr const char* problem_inertia_input_doc =
    R"(Sets an inertia input, like set_payload() at the frame of the input.

Parameters
----------
input : str or int
    Name or index.
payload : InertiaSpec
    Inertia of the payload, in the axes of the frame.)";

constexpr const char* problem_reset_input_doc = R"(Removes the value that set_input() has set.

Parameters
----------
input : str or int
    Name or index.)";

constexpr const char* problem_input_at_doc =
    R"(Returns the value of a scalar, vector or rotation input at a knot.

Parameters
----------
input : str or int
    Name or index.
knot : int

Returns
-------
ndarray, shape (n,)
    Value; empty if the input has none.)";

int input_index(const Problem& problem, const char* call, const Name& input) {
  if (const auto* name = std::get_if<std::string>(&input)) return problem.input_index(*name);
  const int inputs = static_cast<int>(problem.spec().inputs.size());
  const int index = std::get<int>(input);
  if (index < 0 || index >= inputs)
    throw Error(
        std::string(call) + ": input " + std::to_string(index) + " does not exist; " +
        (inputs == 0 ? "the problem has no inputs" : "wanted 0 to " + std::to_string(inputs - 1)));
  return index;
}

/// Returns the number of entries of an input; 0 for a surface or an inertia.
int entries_of(const InputSpec& input) {
  switch (input.kind) {
    case InputKind::Scalar:
      return 1;
    case InputKind::Vector:
      return input.value.size();
    case InputKind::Rotation:
      return 4;
    case InputKind::Surface:
    case InputKind::Inertia:
      break;
  }
  return 0;
}

/// Returns the number or vector `given` as a vector. Throws Error if `input` has another number of
/// entries. Surfaces and inertias have no entries; Problem::set_input() rejects vectors for them.
Eigen::VectorXd input_entries(const char* call, const char* argument, const Numbers& given,
                              const InputSpec& input) {
  if (given.ndim() > 1)
    throw Error(std::string(call) + ": " + argument + " is " + what_came(given) +
                "; wanted a number or a vector");
  const int wanted = entries_of(input);
  if (wanted > 0) check_size(call, argument, given.size(), wanted);
  return Eigen::Map<const Eigen::VectorXd>(given.data(), given.size());
}

void set_input_value(ProblemMachine& self, const Name& name, const Numbers& value,
                     const std::optional<Numbers>& decaying,
                     const std::optional<double>& decay_time) {
  constexpr const char* call = "Problem.set_input";
  const Busy::Lock lock(self.busy, call);
  const int input = input_index(self.problem, call, name);
  const InputSpec& spec = self.problem.spec().inputs[static_cast<std::size_t>(input)];
  const Eigen::VectorXd entries = input_entries(call, "value", value, spec);
  const auto accept = [&](Status status) {
    const std::string of = std::string(call) + ": input " + in_quotes(spec.name);
    if (status == Status::NotNormalized)
      throw Error(
          of + ": the value is not a quaternion of length 1; wanted a unit quaternion x, y, z, w");
    if (status == Status::NotFinite && entries.allFinite())
      throw Error(
          of + " is " + number(entries[0]) +
          "; wanted a friction coefficient of at least 0, with and without the decaying part");
    require(status, call);
  };
  if (decaying.has_value() != decay_time.has_value())
    throw Error(std::string(call) + ": " + (decaying ? "decay_time" : "decaying") +
                " is missing; wanted decaying and decay_time together");
  if (!decaying) {
    accept(self.problem.set_input(input, entries));
    return;
  }
  if (!(*decay_time > 0.0))
    throw Error(std::string(call) + ": decay_time is " + number(*decay_time) +
                " s; wanted a positive number");
  const Eigen::VectorXd faded = input_entries(call, "decaying", *decaying, spec);
  if (!faded.allFinite()) require(Status::NotFinite, call);
  accept(self.problem.set_input(input, entries, faded, *decay_time));
}

/// Binds the overloads of set_input(). The overload for vectors comes last, because it accepts all
/// objects that NumPy can convert to arrays.
void bind_set_input(ProblemClass& c) {
  c.def(
       "set_input",
       [](ProblemMachine& self, const Name& input, const Quadric& surface, double depth) {
         constexpr const char* call = "Problem.set_input";
         const Busy::Lock lock(self.busy, call);
         surface.check(call);
         if (!(depth >= 0.0))
           throw Error(std::string(call) + ": depth is " + number(depth) +
                       " m; wanted at least 0 m");
         require(self.problem.set_input(input_index(self.problem, call, input), surface, depth),
                 call);
       },
       py::arg("input"), py::arg("surface"), py::arg("depth") = 0.0, problem_surface_input_doc)
      .def(
          "set_input",
          [](ProblemMachine& self, const Name& input, const InertiaSpec& payload) {
            constexpr const char* call = "Problem.set_input";
            const Busy::Lock lock(self.busy, call);
            const int index = input_index(self.problem, call, input);
            check_payload(call, payload);
            require(self.problem.set_input(index, payload), call);
          },
          py::arg("input"), py::arg("payload"), problem_inertia_input_doc)
      .def("set_input", &set_input_value, py::arg("input"), py::arg("value"),
           py::arg("decaying") = py::none(), py::arg("decay_time") = py::none(), problem_input_doc);
}

}  // namespace

void bind_inputs(ProblemClass& c) {
  c.def(
       "input_index",
       [](const ProblemMachine& self, const std::string& name) {
         return self.problem.input_index(name);
       },
       py::arg("name"),
       "Returns the index of an input. Raises Error with the nearest name for an unknown input.")
      .def(
          "reset_input",
          [](ProblemMachine& self, const Name& input) {
            constexpr const char* call = "Problem.reset_input";
            const Busy::Lock lock(self.busy, call);
            self.problem.reset_input(input_index(self.problem, call, input));
          },
          py::arg("input"), problem_reset_input_doc)
      .def(
          "input_at",
          [](const ProblemMachine& self, const Name& input, int knot) {
            constexpr const char* call = "Problem.input_at";
            check_knot(call, knot, self.problem.knots());
            return self.problem.input_at(input_index(self.problem, call, input), knot);
          },
          py::arg("input"), py::arg("knot"), problem_input_at_doc);
  bind_set_input(c);
}

}  // namespace burnish::python
