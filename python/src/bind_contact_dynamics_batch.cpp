// Bindings of the contact dynamics of many states.
#include <cstdint>

#include "bind_derivatives.hpp"
#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "machine.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* batch_forward_doc = R"(Computes a and lambda_ of several states.

Rows of float64 are read without a copy.

Parameters
----------
q : array_like, shape (n, nq)
    Configurations, with n at most the capacity.
v : array_like, shape (n, nv)
    Velocities.
tau : array_like, shape (n, nv)
    Torques [Nm or N].

Returns
-------
Status
    Most severe status; `statuses` has those of all states.

Raises
------
Error
    If sizes are wrong.)";

constexpr const char* batch_forward_derivatives_doc =
    R"(Computes the results of forward() and the six derivative blocks.

Parameters
----------
q : array_like, shape (n, nq)
    Configurations, with n at most the capacity.
v : array_like, shape (n, nv)
    Velocities.
tau : array_like, shape (n, nv)
    Torques [Nm or N].

Returns
-------
Status
    Most severe status; `statuses` has those of all states.

Raises
------
Error
    If sizes are wrong.)";

constexpr const char* batch_active_doc =
    R"(Activates or deactivates a contact. Invalidates previous results.

Parameters
----------
contact : str or int
    Name or index.
active : bool)";

constexpr const char* batch_init_doc =
    R"(Compiles contacts for a model, and allocates memory for several states.

Parameters
----------
model : Model
contacts : sequence of ContactSpec
capacity : int
    Largest number of states.
solver : ContactSolver, optional
threads : int
    Number of threads that share the states, including the calling one.
pin_threads : bool
    If True, each other thread runs on one core (Linux only).

Raises
------
Error
    If an argument is invalid.)";

constexpr const char* batch_explanation_doc = R"(Explains the status of a state.

Parameters
----------
state : int
    Index of the state.

Returns
-------
str
    Sentence with the cause: joints that move no mass, or contact rows that cannot be satisfied.)";

/// Array with a state per row. The library uses the same memory as a matrix with a state per
/// column.
using Rows = Eigen::Ref<const RowMatrix>;

struct Batch {
  Batch(const Model& model, const std::vector<ContactSpec>& specs, int capacity,
        const ContactSolver& solver, int threads, bool pin_threads)
      : machine(model, specs, capacity, solver, threads, pin_threads),
        robot(model.name),
        nq(model.nq),
        nv(model.nv) {
    const ContactSet set(model, specs);
    for (const ContactSpec& contact : set.specs()) names.push_back(contact.name);
  }

  static void require_shape(const char* name, const char* argument, const Rows& given,
                            Eigen::Index rows, int columns) {
    if (given.rows() == rows && given.cols() == columns) return;
    throw Error(std::string(name) + ": " + argument + " is " + std::to_string(given.rows()) +
                " x " + std::to_string(given.cols()) + "; wanted " + std::to_string(rows) + " x " +
                std::to_string(columns) + ", one row per state");
  }
  Status run(const char* name, const Rows& q, const Rows& v, const Rows& tau, bool derivatives) {
    require_shape(name, "q", q, q.rows(), nq);
    require_shape(name, "v", v, q.rows(), nv);
    require_shape(name, "tau", tau, q.rows(), nv);
    if (q.rows() < 1 || q.rows() > machine.capacity())
      throw Error(std::string(name) + ": there are " + std::to_string(q.rows()) +
                  " states; wanted 1 to " + std::to_string(machine.capacity()) + ", the capacity");
    const Busy::Lock lock(busy, name);
    const py::gil_scoped_release unlocked;
    states = static_cast<int>(q.rows());
    differentiated = derivatives;
    most_severe = derivatives ? machine.forward_with_derivatives(q.transpose(), v.transpose(),
                                                                 tau.transpose())
                              : machine.forward(q.transpose(), v.transpose(), tau.transpose());
    return most_severe;
  }
  void require_result(const char* name, bool of_derivatives) const {
    if (states > 0 && (differentiated || !of_derivatives)) return;
    throw EvaluationError("ContactDynamicsBatch." + std::string(name) + ": this is a result of " +
                          (of_derivatives ? "forward_with_derivatives()"
                                          : "forward() or forward_with_derivatives()") +
                          ", which was not the last call");
  }

  ContactDynamicsBatch machine;
  std::string robot;
  std::vector<std::string> names;  ///< Names of the contacts
  int nq, nv;
  int states = 0;  ///< Number of states in the last evaluation
  bool differentiated = false;
  Status most_severe = Status::Ok;
  Busy busy;
};

using BatchClass = py::class_<Batch>;
constexpr py::ssize_t number_size = sizeof(double);

/// Binds a property with a result of all states, as a view of the memory of the batch.
template <class View>
void result(BatchClass& of, const char* name, View (ContactDynamicsBatch::*view)(int) const,
            bool of_derivatives, const char* text) {
  of.def_property_readonly(
      name,
      [=](const py::object& self) {
        auto& batch = py::cast<Batch&>(self);
        const Busy::Lock lock(batch.busy, name);
        batch.require_result(name, of_derivatives);
        const View first = (batch.machine.*view)(0);
        // With a single state, the stride between states is arbitrary.
        const py::ssize_t stride =
            batch.states > 1 ? (batch.machine.*view)(1).data() - first.data() : first.size();
        std::vector<py::ssize_t> sizes{batch.states, first.rows()}, strides{stride * number_size};
        if constexpr (std::is_same_v<View, MatrixView>) {
          sizes.push_back(first.cols());
          strides.push_back(first.cols() * number_size);
        }
        strides.push_back(number_size);
        return view_of(first.data(), sizes, strides, self);
      },
      text);
}

void bind_results(BatchClass& of) {
  using B = ContactDynamicsBatch;
  result(of, "a", &B::a, false,
         "Joint accelerations, shape (n, nv) [rad/s^2 or m/s^2], a read-only view.");
  result(of, "lambda_", &B::lambda, false,
         "Contact forces, shape (n, rows) [N or Nm], a read-only view.");
  result(of, "da_dq", &B::da_dq, true,
         "da/dq with respect to the right tangent increment of q, shape (n, nv, nv), a read-only "
         "view.");
  result(of, "da_dv", &B::da_dv, true, "da/dv, shape (n, nv, nv), a read-only view.");
  result(of, "da_dtau", &B::da_dtau, true, "da/dtau, shape (n, nv, nv), a read-only view.");
  result(of, "dlambda_dq", &B::dlambda_dq, true,
         "dlambda/dq, shape (n, rows, nv), a read-only view.");
  result(of, "dlambda_dv", &B::dlambda_dv, true,
         "dlambda/dv, shape (n, rows, nv), a read-only view.");
  result(of, "dlambda_dtau", &B::dlambda_dtau, true,
         "dlambda/dtau, shape (n, rows, nv), a read-only view.");
  of.def_property_readonly(
        "statuses",
        [](Batch& self) {
          const Busy::Lock lock(self.busy, "statuses");
          self.require_result("statuses", false);
          py::array_t<std::uint8_t> all(self.states);
          std::uint8_t* out = all.mutable_data();
          for (int i = 0; i < self.states; ++i)
            out[i] = static_cast<std::uint8_t>(self.machine.status(i));
          return all;
        },
        "Statuses of the states, shape (n,), uint8 values of Status, a copy. Results of a state "
        "with a status above NOT_CONVERGED are zero.")
      .def_property_readonly(
          "status",
          [](const Batch& self) {
            self.require_result("status", false);
            return self.most_severe;
          },
          "Most severe status of all states.")
      .def(
          "explanation",
          [](const Batch& self, int state) {
            self.require_result("explanation", false);
            if (state < 0 || state >= self.states)
              throw Error("ContactDynamicsBatch.explanation: there is no state " +
                          std::to_string(state) + "; the last call had " +
                          std::to_string(self.states) + " states");
            return self.machine.explanation(state);
          },
          py::arg("state"), batch_explanation_doc);
}

std::unique_ptr<Batch> make_batch(const Model& model, const std::vector<ContactSpec>& contacts,
                                  int capacity, const std::optional<ContactSolver>& solver,
                                  int threads, bool pin_threads) {
  return std::make_unique<Batch>(model, contacts, capacity, solver.value_or(ContactSolver{}),
                                 threads, pin_threads);
}

}  // namespace

void bind_contact_dynamics_batch(py::module_& m) {
  m.def("pack_width", &pack_width,
        "Returns the number of states in one SIMD register of the target processor.");
  BatchClass of(
      m, "ContactDynamicsBatch",
      "Contact dynamics of many states with common contacts, one state per SIMD lane.\n"
      "\n"
      "Results are read-only views with a row per state. They keep the memory of the batch alive, "
      "and the next call overwrites them: copy results that must last. Only one call at a time is "
      "allowed.");
  of.def(py::init(&make_batch), py::arg("model"), py::arg("contacts"), py::arg("capacity"),
         py::arg("solver") = py::none(), py::arg("threads") = 1, py::arg("pin_threads") = false,
         batch_init_doc)
      .def_readonly("nq", &Batch::nq, "Number of entries of q.")
      .def_readonly("nv", &Batch::nv, "Number of entries of v and tau.")
      .def_property_readonly(
          "rows", [](const Batch& self) { return self.machine.rows(); },
          "Number of rows of the active contacts.")
      .def_property_readonly(
          "capacity", [](const Batch& self) { return self.machine.capacity(); },
          "Largest number of states.")
      .def_property_readonly(
          "threads", [](const Batch& self) { return self.machine.threads(); },
          "Number of threads that share the states, including the calling one.")
      .def(
          "set_active",
          [](Batch& self, const NumberOrName& contact, bool active) {
            constexpr const char* name = "ContactDynamicsBatch.set_active";
            const Busy::Lock lock(self.busy, name);
            self.machine.set_active(contact_number(name, contact, self.names), active);
            self.states = 0;
          },
          py::arg("contact"), py::arg("active"), batch_active_doc)
      .def(
          "forward",
          [](Batch& self, const Rows& q, const Rows& v, const Rows& tau) {
            return self.run("ContactDynamicsBatch.forward", q, v, tau, false);
          },
          py::arg("q"), py::arg("v"), py::arg("tau"), batch_forward_doc)
      .def(
          "forward_with_derivatives",
          [](Batch& self, const Rows& q, const Rows& v, const Rows& tau) {
            return self.run("ContactDynamicsBatch.forward_with_derivatives", q, v, tau, true);
          },
          py::arg("q"), py::arg("v"), py::arg("tau"), batch_forward_derivatives_doc)
      .def("__repr__", [](const Batch& self) {
        return "<ContactDynamicsBatch of '" + self.robot +
               "': " + std::to_string(self.machine.capacity()) + " states, " +
               std::to_string(self.machine.rows()) + " rows, " +
               std::to_string(self.machine.threads()) + " threads>";
      });
  bind_results(of);
}

}  // namespace burnish::python
