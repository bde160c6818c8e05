// Bindings of the check of derivatives and of the diagnosis of contacts, and helpers of this layer.
#include "bind_derivatives.hpp"

#include <algorithm>

namespace burnish::python {

void require_size(const char* what, const char* argument, Eigen::Index entries, int wanted) {
  if (entries == wanted) return;
  throw Error(std::string(what) + ": " + argument + " has " + std::to_string(entries) +
              " entries; wanted " + std::to_string(wanted));
}

int contact_number(const char* what, const NumberOrName& contact,
                   const std::vector<std::string>& names) {
  const int count = static_cast<int>(names.size());
  if (const int* number = std::get_if<int>(&contact)) {
    if (*number >= 0 && *number < count) return *number;
    throw Error(std::string(what) + ": there is no contact " + std::to_string(*number) +
                "; the set has " + std::to_string(count) + " contacts");
  }
  const auto& name = std::get<std::string>(contact);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  throw Error(std::string(what) + ": unknown contact '" + name + "'" + did_you_mean(name, names));
}

namespace {

// Docstrings.

constexpr const char* check_derivatives_doc =
    R"(Compares all derivative blocks of ContactDynamics with finite differences at random states.

Parameters
----------
model : Model
options : CheckOptions, optional

Returns
-------
CheckReport

Raises
------
Error
    If the options are invalid.)";

constexpr const char* diagnose_doc =
    R"(Finds redundant contact rows: rows that depend on previous rows.

A row is redundant if the part of it that is independent of the previous rows has at most
`tolerance` of its length, in the metric M^-1.

Parameters
----------
model : Model
contacts : sequence of ContactSpec
q : array_like, shape (nq,)
    Configuration.
active : sequence of str or int
    Names or indices of the active contacts; empty: all contacts.
tolerance : float

Returns
-------
ContactDiagnosis

Raises
------
Error
    If q is invalid, or a contact is unknown.)";

CheckReport check(const Model& model, const std::optional<CheckOptions>& options) {
  CheckOptions used = options.value_or(CheckOptions{});
  const auto report_progress = used.progress;
  used.progress = [&report_progress](int done, int total) {
    if (report_progress) report_progress(done, total);
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  const py::gil_scoped_release unlocked;
  return check_derivatives(model, used);
}

ContactDiagnosis diagnosis(const Model& model, const std::vector<ContactSpec>& contacts,
                           const Eigen::Ref<const Eigen::VectorXd>& q,
                           const std::vector<NumberOrName>& active, double tolerance) {
  const ContactSet set(model, contacts);
  std::vector<std::string> names;
  for (const ContactSpec& contact : set.specs()) names.push_back(contact.name);
  std::vector<int> examined;
  for (const NumberOrName& contact : active)
    examined.push_back(contact_number("diagnose", contact, names));
  return diagnose(model, set, q, examined, tolerance);
}

}  // namespace

void bind_derivatives(py::module_& m) {
  bind_contact_dynamics(m);
  bind_contact_dynamics_batch(m);
  bind_rigid_body(m);

  m.def("check_derivatives", &check, py::arg("model"), py::arg("options") = py::none(),
        check_derivatives_doc);
  m.def("default_check_references", &default_check_references,
        "Returns the default references of check_derivatives(): all four kinds; the surface is "
        "tilted.");
  m.def("default_check_surfaces", &default_check_surfaces,
        "Returns the default curved surfaces of check_derivatives(): a saddle.");
  m.def("default_check_directions", &default_check_directions,
        "Returns the default directions of check_derivatives().");
  m.def("default_check_gains", &default_check_gains,
        "Returns the default gains of check_derivatives(): none, SPLIT, and LOG6 with unequal "
        "gains per direction.");
  m.def("check_report_text", &CheckReport::text, py::arg("report"));

  m.def("diagnose", &diagnosis, py::arg("model"), py::arg("contacts"), py::arg("q"),
        py::arg("active") = std::vector<NumberOrName>{},
        py::arg("tolerance") = independence_tolerance, diagnose_doc);
  m.def("redundant_row_text", &RedundantRow::text, py::arg("row"));
  m.def("contact_diagnosis_text", &ContactDiagnosis::text, py::arg("diagnosis"));
}

}  // namespace burnish::python
