// The checker, the diagnosis of contacts, and what the classes of this layer have in common.
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
                "; the set has " + std::to_string(count));
  }
  const auto& name = std::get<std::string>(contact);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  throw Error(std::string(what) + ": unknown contact '" + name + "'" + did_you_mean(name, names));
}

namespace {

CheckReport check(const Model& model, const std::optional<CheckOptions>& options) {
  CheckOptions used = options.value_or(CheckOptions{});
  const auto told = used.progress;
  used.progress = [&told](int done, int total) {
    if (told) told(done, total);
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
        "Compares every derivative block of ContactDynamics at random states with differences of "
        "the values. Raises Error for options that cannot be used.");
  m.def("default_check_references", &default_check_references,
        "References that check_derivatives() tries: all four, the surface tilted.");
  m.def("default_check_surfaces", &default_check_surfaces,
        "Curved surfaces that check_derivatives() tries: a saddle.");
  m.def("default_check_directions", &default_check_directions,
        "Directions that check_derivatives() tries.");
  m.def("default_check_gains", &default_check_gains,
        "Gains that check_derivatives() tries: none; SPLIT; LOG6, unequal by direction.");
  m.def("check_report_text", &CheckReport::text, py::arg("report"));

  m.def(
      "diagnose", &diagnosis, py::arg("model"), py::arg("contacts"), py::arg("q"),
      py::arg("active") = std::vector<NumberOrName>{},
      py::arg("tolerance") = independence_tolerance,
      "Which rows of the contacts (of the `active` ones, by name or number; all if empty) depend "
      "on rows before them at q (nq,): no more than `tolerance` of their length in the metric "
      "M^-1, "
      "or of what the joints could move along them, is left beside those. Raises Error for a bad q "
      "and unknown names.");
  m.def("redundant_row_text", &RedundantRow::text, py::arg("row"));
  m.def("contact_diagnosis_text", &ContactDiagnosis::text, py::arg("diagnosis"));
}

}  // namespace burnish::python
