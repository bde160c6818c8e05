#include "files/problem_scope.hpp"

#include <algorithm>
#include <tuple>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "contact/force_column.hpp"

namespace burnish::files {
namespace {

std::string name_of_contact(const ContactSpec& contact) {
  return contact.name.empty() ? contact.tool : contact.name;
}

bool holds(const std::vector<std::string>& contacts, const std::string& name) {
  return std::find(contacts.begin(), contacts.end(), name) != contacts.end();
}

}  // namespace

std::vector<const Joint*> ProblemScope::driven() const {
  return driven_joints(spec.model, spec.actuation);
}

int ProblemScope::controls() const {
  int sum = 0;
  for (const Joint* joint : driven()) sum += joint->nv;
  return sum;
}

std::vector<std::string> force_state_columns(const ProblemSpec& spec) {
  std::vector<std::string> columns;
  for (const std::string& name : spec.force_states)
    for (const ContactSpec& contact : spec.contacts)
      for (int d = 0; d < 6; ++d)
        if (name_of_contact(contact) == name && contact.directions.has(d))
          columns.push_back(force_column(contact, d));
  return columns;
}

Eigen::VectorXd force_states_of(const ProblemSpec& spec, const HeldForces& forces) {
  std::vector<double> rows;
  for (const std::string& name : spec.force_states)
    for (const ContactSpec& contact : spec.contacts) {
      if (name_of_contact(contact) != name) continue;
      const auto found = forces.find(name);
      for (int i = 0; i < contact.directions.count(); ++i)
        rows.push_back(found == forces.end() ? 0.0 : found->second[i]);
    }
  return Eigen::Map<const Eigen::VectorXd>(rows.data(), static_cast<Eigen::Index>(rows.size()));
}

Holding hold(const ProblemSpec& spec, const std::vector<std::string>& contacts,
             const Eigen::VectorXd& q, const HeldForces& prescribed) {
  const int nv = spec.model.nv;
  // hold() uses only the bias and the Jacobian. The compliance `mu` allows singular contacts.
  ContactDynamics dynamics(spec.model, contacts_at(spec.contacts, spec.start_time), {.mu = 1e-6});
  for (std::size_t c = 0; c < spec.contacts.size(); ++c)
    dynamics.set_active(static_cast<int>(c), holds(contacts, name_of_contact(spec.contacts[c])));
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(nv);
  if (!is_usable(dynamics.forward(q, zero, zero)))
    throw Error(
        "'hold' has no solution: the dynamics at the start cannot be evaluated; wanted another "
        "posture at the start");
  // S^T u + J^T lambda = b, with unknown forces lambda. Prescribed forces are included in b.
  const std::vector<const Joint*> driven = driven_joints(spec.model, spec.actuation);
  int nu = 0;
  for (const Joint* joint : driven) nu += joint->nv;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(nv, nu + dynamics.rows());
  int column = 0;
  for (const Joint* joint : driven)
    for (int k = 0; k < joint->nv; ++k) A(joint->v_index + k, column++) = 1.0;
  Eigen::VectorXd b = dynamics.bias();
  int row = 0;
  std::vector<std::tuple<std::string, int, int>> free;  // contact, first column, number of rows
  Holding result;
  for (const ContactSpec& contact : spec.contacts) {
    const std::string name = name_of_contact(contact);
    if (!holds(contacts, name)) continue;
    const int rows = contact.directions.count();
    const Eigen::MatrixXd J_T = dynamics.jacobian().middleRows(row, rows).transpose();
    row += rows;
    const auto given = prescribed.find(name);
    if (given != prescribed.end()) {
      b -= J_T * given->second;
      result.forces[name] = given->second;
      continue;
    }
    A.middleCols(column, rows) = J_T;
    free.emplace_back(name, column, rows);
    column += rows;
  }
  const Eigen::VectorXd solution = least_squares(A.leftCols(column), b);
  result.control = solution.head(nu);
  for (const auto& [name, first, rows] : free) result.forces[name] = solution.segment(first, rows);
  result.residual = (A.leftCols(column) * solution - b).cwiseAbs().maxCoeff();
  return result;
}

bool is_hold(const Reader& reader) { return reader.is("hold") || reader.has("hold"); }

HeldForces read_held_forces(const ProblemScope& scope, const std::vector<std::string>& contacts,
                            const Reader& reader) {
  HeldForces forces;
  if (reader.is("hold")) return forces;
  reader.allow_only({"hold"});
  for (const auto& [name, value] : reader["hold"].items()) {
    const ContactSpec& contact = reader["hold"].named(
        [&, &of = name]() -> const ContactSpec& { return ocp::contact_named(scope.spec, of); });
    if (!holds(contacts, name))
      value.refuse("the contact is not active in the stage; wanted only active contacts");
    const int rows = contact.directions.count();
    forces[name] = value.is_number() ? Eigen::VectorXd::Constant(1, value.number())
                                     : Eigen::VectorXd(value.numbers(rows));
    if (forces[name].size() != rows)
      value.refuse("it is a single number; wanted a list of " + std::to_string(rows) +
                   " numbers (" + contact.directions.text() + ")");
  }
  return forces;
}

}  // namespace burnish::files
