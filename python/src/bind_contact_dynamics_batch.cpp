// Contact dynamics of many states at once.
#include <cstdint>

#include "bind_derivatives.hpp"
#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "machine.hpp"

namespace burnish::python {

namespace {

/// A state per row. Its transpose is what the library takes: the same memory, a state per column.
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
                std::to_string(columns) + ", a row per state");
  }
  Status run(const char* name, const Rows& q, const Rows& v, const Rows& tau, bool derivatives) {
    require_shape(name, "q", q, q.rows(), nq);
    require_shape(name, "v", v, q.rows(), nv);
    require_shape(name, "tau", tau, q.rows(), nv);
    if (q.rows() < 1 || q.rows() > machine.capacity())
      throw Error(std::string(name) + ": " + std::to_string(q.rows()) +
                  " states; wanted 1 to the capacity of " + std::to_string(machine.capacity()));
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
    throw EvaluationError("ContactDynamicsBatch." + std::string(name) + ": a result of " +
                          (of_derivatives ? "forward_with_derivatives()"
                                          : "forward() or forward_with_derivatives()") +
                          ", which was not the last call");
  }

  ContactDynamicsBatch machine;
  std::string robot;
  std::vector<std::string> names;  ///< of the contacts
  int nq, nv;
  int states = 0;  ///< evaluated last
  bool differentiated = false;
  Status most_severe = Status::Ok;
  Busy busy;
};

using BatchClass = py::class_<Batch>;
constexpr py::ssize_t number_size = sizeof(double);

/// A property that shows a result of all states where the batch keeps it.
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
        // With one state only, there is no second to tell the stride from.
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
  result(of, "a", &B::a, false, "(n, nv), rad/s^2 or m/s^2: a read-only view.");
  result(of, "lambda_", &B::lambda, false, "(n, rows), N or Nm: a read-only view.");
  result(of, "da_dq", &B::da_dq, true,
         "(n, nv, nv), by the right tangent increment of q: a read-only view.");
  result(of, "da_dv", &B::da_dv, true, "(n, nv, nv): a read-only view.");
  result(of, "da_dtau", &B::da_dtau, true, "(n, nv, nv): a read-only view.");
  result(of, "dlambda_dq", &B::dlambda_dq, true, "(n, rows, nv): a read-only view.");
  result(of, "dlambda_dv", &B::dlambda_dv, true, "(n, rows, nv): a read-only view.");
  result(of, "dlambda_dtau", &B::dlambda_dtau, true, "(n, rows, nv): a read-only view.");
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
        "(n,) of uint8, values of Status: a copy. Results of a state above NOT_CONVERGED are zero.")
      .def_property_readonly(
          "status",
          [](const Batch& self) {
            self.require_result("status", false);
            return self.most_severe;
          },
          "The most severe of them.")
      .def(
          "explanation",
          [](const Batch& self, int state) {
            self.require_result("explanation", false);
            if (state < 0 || state >= self.states)
              throw Error("ContactDynamicsBatch.explanation: there is no state " +
                          std::to_string(state) + "; the last call had " +
                          std::to_string(self.states));
            return self.machine.explanation(state);
          },
          py::arg("state"),
          "The status of a state in one sentence that names what is to blame: the joints that move "
          "no mass, the contact rows that cannot be held.");
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
        "States that one register of the processor this library was built for holds.");
  BatchClass of(
      m, "ContactDynamicsBatch",
      "Contact dynamics of many states with the same contacts, packed, one state per SIMD "
      "lane.\n\n"
      "Results are read-only views, a row per state, on memory of the batch, which they keep "
      "alive: the next call writes over them. Copy what has to last. One call at a time.");
  of.def(py::init(&make_batch), py::arg("model"), py::arg("contacts"), py::arg("capacity"),
         py::arg("solver") = py::none(), py::arg("threads") = 1, py::arg("pin_threads") = false,
         "Room for `capacity` states, shared out among `threads`, the calling one included; with "
         "`pin_threads` the others stay on a core each (Linux alone). Raises Error with one "
         "sentence.")
      .def_readonly("nq", &Batch::nq, "Columns of q.")
      .def_readonly("nv", &Batch::nv, "Columns of v and tau.")
      .def_property_readonly(
          "rows", [](const Batch& self) { return self.machine.rows(); },
          "Rows of the active contacts.")
      .def_property_readonly(
          "capacity", [](const Batch& self) { return self.machine.capacity(); },
          "States that there is room for.")
      .def_property_readonly(
          "threads", [](const Batch& self) { return self.machine.threads(); },
          "Threads that share the states, the calling one included.")
      .def(
          "set_active",
          [](Batch& self, const NumberOrName& contact, bool active) {
            constexpr const char* name = "ContactDynamicsBatch.set_active";
            const Busy::Lock lock(self.busy, name);
            self.machine.set_active(contact_number(name, contact, self.names), active);
            self.states = 0;
          },
          py::arg("contact"), py::arg("active"),
          "Makes or breaks a contact (name or number). Results before it are gone.")
      .def(
          "forward",
          [](Batch& self, const Rows& q, const Rows& v, const Rows& tau) {
            return self.run("ContactDynamicsBatch.forward", q, v, tau, false);
          },
          py::arg("q"), py::arg("v"), py::arg("tau"),
          "Fills a and lambda_. q: (n, nq), v: (n, nv), tau: (n, nv), Nm or N, n at most the "
          "capacity; float64 rows are read in place. Returns the most severe status and raises for "
          "none of them: see statuses. Raises Error for wrong sizes.")
      .def(
          "forward_with_derivatives",
          [](Batch& self, const Rows& q, const Rows& v, const Rows& tau) {
            return self.run("ContactDynamicsBatch.forward_with_derivatives", q, v, tau, true);
          },
          py::arg("q"), py::arg("v"), py::arg("tau"), "The same, and the six derivative blocks.")
      .def("__repr__", [](const Batch& self) {
        return "<ContactDynamicsBatch of '" + self.robot +
               "': " + std::to_string(self.machine.capacity()) + " states, " +
               std::to_string(self.machine.rows()) + " rows, " +
               std::to_string(self.machine.threads()) + " threads>";
      });
  bind_results(of);
}

}  // namespace burnish::python
