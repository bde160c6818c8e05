#include "burnish/derivatives/contact_dynamics.hpp"

#include <algorithm>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "contact/contact_kinematics.tpp"
#include "derivatives/constrained_derivatives.hpp"
#include "derivatives/explanation.hpp"
#include "derivatives/kinematic_state.hpp"
#include "derivatives/wrench_transport.hpp"
#include "dynamics/regressor.tpp"

namespace burnish {

extern template class ConstrainedDynamics<double>;
extern template class ConstrainedDerivatives<double>;

namespace {

/// Evaluation that the workspace holds.
enum class Evaluation { Nothing, Forward, Inverse, Acceleration };

}  // namespace

struct ContactDynamics::Impl {
  Impl(const Model& robot, const std::vector<ContactSpec>& specs, const ContactSolver& solver)
      : model(robot),
        set(robot, specs),
        dynamics(robot, set, solver),
        derivatives(dynamics),
        nq(robot.nq),
        nv(robot.nv),
        active(to_size(set.size()), 1),
        mass(RowMatrix::Zero(nv, nv)),
        jacobian(RowMatrix::Zero(set.rows(), nv)),
        negated_q(RowMatrix::Zero(set.rows(), nv)),
        negated_v(RowMatrix::Zero(set.rows(), nv)),
        velocity(Eigen::VectorXd::Zero(set.rows())),
        error(Eigen::VectorXd::Zero(set.rows())),
        zeros(Eigen::VectorXd::Zero(set.rows())) {
    entries.reserve(to_size(nv));
    for (const CompiledContact& contact : set.contacts())
      references.push_back(contact.spec.reference);
    for (const int joint : robot.joint_of_v) joint_names.push_back(robot.joints[joint].name);
  }

  void check(const char* call, int contact) const {
    if (contact < 0 || contact >= set.size())
      throw Error(std::string(call) + ": contact " + std::to_string(contact) +
                  " does not exist; the set has " + std::to_string(set.size()) + " contacts");
  }
  MatrixView rows_of_a(const std::vector<double>& stacked) const {
    return {stacked.data(), nv, nv};
  }
  MatrixView rows_of_lambda(const std::vector<double>& stacked) const {
    return {stacked.data() + nv * nv, dynamics.rows(), nv};
  }

  /// Returns the residual acceleration of rows that contradict each other in the last forward().
  VectorView unmet() const {
    const std::vector<double>& found = dynamics.contradiction().unmet;
    return {evaluated == Evaluation::Forward && !found.empty() ? found.data() : zeros.data(),
            dynamics.rows()};
  }
  /// Returns true if the last evaluation determined lambda.
  bool has_forces() const {
    return evaluated == Evaluation::Forward || evaluated == Evaluation::Inverse;
  }

  void invalidate() {
    evaluated = Evaluation::Nothing;
    differentiated = false;
  }
  /// Invalidates the last evaluation after a change of contacts.
  void change_contacts() {
    invalidate();
    contacts_changed = true;
  }
  void check_bodies(const char* call, std::span<const int> bodies) const {
    const auto count = static_cast<int>(model.joints.size());
    for (const int body : bodies)
      if (body < 0 || body >= count)
        throw Error(std::string(call) + ": body " + std::to_string(body) +
                    " does not exist; the robot has " + std::to_string(count) + " bodies");
  }
  /// Fills the regressor Y of `bodies` at the accelerations of the last evaluation.
  void fill_regressor(std::span<const int> bodies, RowMatrix& out) {
    const auto columns = static_cast<Eigen::Index>(10 * bodies.size());
    if (out.rows() != nv || out.cols() != columns) out.resize(nv, columns);
    out.setZero();
    accelerate(dynamics.tree(), dynamics.kinematics(), dynamics.a.data(),
               dynamics.inverse_dynamics());
    for (std::size_t i = 0; i < bodies.size(); ++i)
      body_regressor(dynamics.tree(), dynamics.kinematics(), dynamics.inverse_dynamics(), bodies[i],
                     out.data() + 10 * i, static_cast<int>(columns));
  }

  Status load(const ConstVectorRef& q, const ConstVectorRef& v) {
    if (q.size() != nq || v.size() != nv) return Status::WrongSize;
    invalidate();
    dynamics.set_state(q.data(), v.data());
    return copy_state();
  }
  /// Loads a state whose kinematics are already computed.
  Status load(const KinematicState& state) {
    if (state.q.size() != nq || state.v.size() != nv ||
        !same_size(state.kinematics, dynamics.kinematics()))
      return Status::WrongSize;
    invalidate();
    dynamics.set_state(state.q.data(), state.v.data(), state.kinematics);
    return copy_state();
  }
  static bool same_size(const Kinematics<double>& a, const Kinematics<double>& b) {
    return a.bodies.size() == b.bodies.size() && a.axes.size() == b.axes.size();
  }

  /// Fills the copies of the mass matrix and of contact quantities, which callers read.
  Status copy_state() {
    const MassMatrix<double>& m = dynamics.mass();
    for (int i = 0; i < nv; ++i)
      for (int j = i; j >= 0; j = dynamics.tree().parent_of_v[j])
        mass(i, j) = mass(j, i) = m.mass[i * nv + j];
    is_loaded = true;
    copy_contacts();
    return dynamics.status();
  }

  /// Fills the copies of the Jacobian and of active contacts' velocities, which callers read.
  void copy_contacts() {
    contacts_changed = false;
    const Delassus<double>& d = dynamics.delassus();
    for (int k = 0; k < nv; ++k)
      for (int r = 0; r < dynamics.rows(); ++r) jacobian(r, k) = d.jacobian_by_v[k * d.stride + r];
    for (const int c : dynamics.active().contacts) {
      const CompiledContact& contact = set.contacts()[c];
      const int first = dynamics.active().first_row[c];
      burnish::contact_velocity(contact, dynamics.contact_states[c], velocity.data() + first);
    }
  }

  /// Loads the state and runs `kernel` on it, unless an argument has the wrong size.
  Status evaluate(const ConstVectorRef& q, const ConstVectorRef& v, Evaluation what, bool sizes_fit,
                  const auto& kernel) {
    if (!sizes_fit || load(q, v) == Status::WrongSize) return Status::WrongSize;
    kernel(dynamics);
    evaluated = what;
    return dynamics.status();
  }
  /// Runs `kernel` if the workspace holds the evaluation that `kernel` differentiates.
  Status differentiate(Evaluation what, const auto& kernel) {
    if (evaluated != what) return Status::NotEvaluated;
    kernel(derivatives, dynamics);
    differentiated = true;
    return dynamics.status();
  }

  /// Fills the pose errors of the last state. The kernel computes them only for contacts with a
  /// proportional gain; this function computes the others.
  void load_error() {
    for (const int c : dynamics.active().contacts) {
      const CompiledContact& contact = set.contacts()[c];
      ContactState<double> state = dynamics.contact_states[c];
      if (!contact.proportional) {
        const auto base = contact_detail::pose_of<double>(contact.base_body, contact.base_R,
                                                          contact.base_p, dynamics.kinematics());
        contact_detail::update_error(contact, base, state);
      }
      burnish::contact_error(contact, state, error.data() + dynamics.active().first_row[c]);
    }
  }

  Model model;
  ContactSet set;
  ConstrainedDynamics<double> dynamics;
  ConstrainedDerivatives<double> derivatives;
  int nq, nv;
  std::vector<char> active;
  std::vector<Reference> references;  ///< Current reference of each contact
  RowMatrix mass, jacobian;           ///< Dense copies, nv x nv and rows x nv
  RowMatrix negated_q, negated_v;     ///< dalpha/dq and dalpha/dv: negated rows of rhs_q and rhs_v
  Eigen::VectorXd velocity, error, zeros;
  bool is_loaded = false;         ///< Whether a state is loaded with the present masses
  bool contacts_changed = false;  ///< Whether contacts changed since the state was loaded
  Evaluation evaluated = Evaluation::Nothing;
  bool differentiated = false;           ///< Whether the derivatives of `evaluated` are valid
  RowMatrix regressor;                   ///< Scratch of inertia_derivatives()
  std::vector<WrenchEntry> entries;      ///< Scratch of wrench_derivatives()
  std::vector<std::string> joint_names;  ///< Joint of each entry of v
};

ContactDynamics::ContactDynamics(const Model& model, const std::vector<ContactSpec>& contacts,
                                 const ContactSolver& solver)
    : impl_(std::make_unique<Impl>(model, contacts, solver)) {}
ContactDynamics::~ContactDynamics() = default;
ContactDynamics::ContactDynamics(ContactDynamics&&) noexcept = default;
ContactDynamics& ContactDynamics::operator=(ContactDynamics&&) noexcept = default;

const ContactSet& ContactDynamics::contacts() const { return impl_->set; }
int ContactDynamics::nv() const { return impl_->nv; }
int ContactDynamics::rows() const { return impl_->dynamics.rows(); }

void ContactDynamics::set_active(int contact, bool active) {
  impl_->check("set_active", contact);
  impl_->active[contact] = active ? 1 : 0;
  impl_->change_contacts();
  impl_->dynamics.set_active(contact, active);
}

bool ContactDynamics::is_active(int contact) const { return impl_->active.at(contact) != 0; }

Status ContactDynamics::set_reference_rotation(int contact, const Eigen::Matrix3d& rotation) {
  impl_->check("set_reference_rotation", contact);
  if (!is_rotation(rotation)) return Status::NotNormalized;
  impl_->references[to_size(contact)].rotation = rotation;
  impl_->change_contacts();
  impl_->dynamics.set_reference_rotation(contact, from_eigen(rotation));
  return Status::Ok;
}

Status ContactDynamics::set_surface(int contact, const Quadric& surface) {
  impl_->check("set_surface", contact);
  if (!impl_->set.contacts()[contact].reference.is_curved)
    throw Error("set_surface: the reference of contact " +
                in_quotes(impl_->set.contacts()[contact].spec.name) +
                " has no curved surface; wanted a reference from Reference::on");
  if (!surface.is_finite()) return Status::NotFinite;
  impl_->references[to_size(contact)].quadric = surface;
  impl_->change_contacts();
  impl_->dynamics.set_surface(contact, {from_eigen(surface.Q), from_eigen(surface.b)});
  return Status::Ok;
}

Status ContactDynamics::set_friction(int contact, double coefficient) {
  impl_->check("set_friction", contact);
  check_has_friction("set_friction", impl_->set.contacts()[contact]);
  if (!std::isfinite(coefficient) || coefficient < 0.0) return Status::NotFinite;
  impl_->change_contacts();
  impl_->dynamics.set_friction(contact, coefficient);
  return Status::Ok;
}

Status ContactDynamics::set_payload(std::string_view frame, const InertiaSpec& payload) {
  const LoadedBody loaded = loaded_body("set_payload", impl_->model, frame, payload);
  if (loaded.status != Status::Ok) return loaded.status;
  impl_->invalidate();
  impl_->is_loaded = false;
  impl_->dynamics.set_body_inertia(loaded.body, body_inertia(loaded.inertia));
  return Status::Ok;
}

std::vector<std::string> ContactDynamics::row_names() const {
  std::vector<std::string> names;
  for (const int c : impl_->dynamics.active().contacts) {
    const CompiledContact& contact = impl_->set.contacts()[c];
    for (const int d : contact.directions)
      names.push_back(contact.spec.name + "/" + std::string(direction_names[d]));
  }
  return names;
}

std::string ContactDynamics::explanation() const {
  std::vector<std::string> joints, rows;
  const std::vector<std::string> names = row_names();
  for (int k = 0; k < impl_->nv; ++k)
    if (impl_->dynamics.moves_no_mass(k, 0)) joints.push_back(impl_->joint_names[k]);
  for (std::size_t r = 0; r < names.size(); ++r)
    if (impl_->dynamics.is_dependent(static_cast<int>(r), 0)) rows.push_back(names[r]);
  std::vector<std::string> jammed;
  for (int c = 0; c < impl_->set.size(); ++c)
    if (impl_->dynamics.jams(c, 0)) jammed.push_back(impl_->set.contacts()[c].spec.name);
  return explain(impl_->dynamics.status(), joints, rows, jammed,
                 unmet_rows(names, {impl_->unmet().data(), names.size()}));
}

Status ContactDynamics::update(const ConstVectorRef& q, const ConstVectorRef& v) {
  return impl_->load(q, v);
}

Status ContactDynamics::update(const RigidBody& body) { return impl_->load(body.state()); }

Status ContactDynamics::forward(const ConstVectorRef& tau) {
  if (!impl_->is_loaded) return Status::NotEvaluated;
  if (tau.size() != impl_->nv) return Status::WrongSize;
  impl_->invalidate();
  if (impl_->contacts_changed) {
    impl_->dynamics.update_contacts();
    impl_->copy_contacts();
  }
  impl_->dynamics.forward(tau.data());
  impl_->evaluated = Evaluation::Forward;
  return impl_->dynamics.status();
}

Status ContactDynamics::forward(const ConstVectorRef& q, const ConstVectorRef& v,
                                const ConstVectorRef& tau) {
  return impl_->evaluate(q, v, Evaluation::Forward, tau.size() == impl_->nv,
                         [&](auto& dynamics) { dynamics.forward(tau.data()); });
}

Status ContactDynamics::forward_derivatives() {
  return impl_->differentiate(Evaluation::Forward, [](auto& d, auto& of) { d.forward(of); });
}

Status ContactDynamics::inverse(const ConstVectorRef& q, const ConstVectorRef& v,
                                const ConstVectorRef& a, const ConstVectorRef& lambda) {
  return impl_->evaluate(q, v, Evaluation::Inverse,
                         a.size() == impl_->nv && lambda.size() == rows(),
                         [&](auto& dynamics) { dynamics.inverse(a.data(), lambda.data()); });
}

Status ContactDynamics::inverse_derivatives() {
  return impl_->differentiate(Evaluation::Inverse, [](auto& d, auto& of) { d.inverse(of); });
}

Status ContactDynamics::acceleration(const ConstVectorRef& q, const ConstVectorRef& v,
                                     const ConstVectorRef& a) {
  return impl_->evaluate(q, v, Evaluation::Acceleration, a.size() == impl_->nv,
                         [&](auto& dynamics) { dynamics.acceleration(a.data()); });
}

Status ContactDynamics::acceleration_derivatives() {
  const int m = rows();
  return impl_->differentiate(Evaluation::Acceleration, [&](auto& d, auto& of) {
    d.acceleration(of);
    impl_->negated_q.topRows(m) = -impl_->rows_of_lambda(d.rhs_q);
    impl_->negated_v.topRows(m) = -impl_->rows_of_lambda(d.rhs_v);
  });
}

Status ContactDynamics::regressor(std::span<const int> bodies, RowMatrix& out) {
  impl_->check_bodies("regressor", bodies);
  if (impl_->evaluated != Evaluation::Forward && impl_->evaluated != Evaluation::Inverse)
    return Status::NotEvaluated;
  impl_->fill_regressor(bodies, out);
  return impl_->dynamics.status();
}

Status ContactDynamics::inertia_derivatives(std::span<const int> bodies, InertiaDerivatives& out) {
  impl_->check_bodies("inertia_derivatives", bodies);
  if (impl_->evaluated != Evaluation::Forward || !impl_->differentiated)
    return Status::NotEvaluated;
  impl_->fill_regressor(bodies, impl_->regressor);
  out.a.noalias() = -da_dtau() * impl_->regressor;
  out.lambda.noalias() = -dlambda_dtau() * impl_->regressor;
  return impl_->dynamics.status();
}

VectorView ContactDynamics::a() const { return {impl_->dynamics.a.data(), impl_->nv}; }
VectorView ContactDynamics::lambda() const { return {impl_->dynamics.lambda.data(), rows()}; }
VectorView ContactDynamics::tau() const { return {impl_->dynamics.tau.data(), impl_->nv}; }
VectorView ContactDynamics::alpha() const { return {impl_->dynamics.alpha.data(), rows()}; }
VectorView ContactDynamics::bias() const { return {impl_->dynamics.mass().bias.data(), impl_->nv}; }
MatrixView ContactDynamics::mass_matrix() const {
  return {impl_->mass.data(), impl_->nv, impl_->nv};
}
MatrixView ContactDynamics::jacobian() const { return {impl_->jacobian.data(), rows(), impl_->nv}; }
MatrixView ContactDynamics::da_dq() const { return impl_->rows_of_a(impl_->derivatives.d_dq); }
MatrixView ContactDynamics::da_dv() const { return impl_->rows_of_a(impl_->derivatives.d_dv); }
MatrixView ContactDynamics::da_dtau() const { return impl_->rows_of_a(impl_->derivatives.d_dtau); }
MatrixView ContactDynamics::dlambda_dq() const {
  return impl_->rows_of_lambda(impl_->derivatives.d_dq);
}
MatrixView ContactDynamics::dlambda_dv() const {
  return impl_->rows_of_lambda(impl_->derivatives.d_dv);
}
MatrixView ContactDynamics::dlambda_dtau() const {
  return impl_->rows_of_lambda(impl_->derivatives.d_dtau);
}
MatrixView ContactDynamics::dtau_dq() const { return impl_->rows_of_a(impl_->derivatives.rhs_q); }
MatrixView ContactDynamics::dtau_dv() const { return impl_->rows_of_a(impl_->derivatives.rhs_v); }
MatrixView ContactDynamics::dalpha_dq() const {
  return {impl_->negated_q.data(), rows(), impl_->nv};
}
MatrixView ContactDynamics::dalpha_dv() const {
  return {impl_->negated_v.data(), rows(), impl_->nv};
}
VectorView ContactDynamics::contact_velocity() const { return {impl_->velocity.data(), rows()}; }
VectorView ContactDynamics::contact_error() const {
  impl_->load_error();
  return {impl_->error.data(), rows()};
}
int ContactDynamics::proximal_iterations() const { return impl_->dynamics.proximal_iterations; }
double ContactDynamics::proximal_residual() const { return impl_->dynamics.proximal_residual[0]; }
VectorView ContactDynamics::unmet() const { return impl_->unmet(); }

Vector6 ContactDynamics::wrench(int contact, const Reference& reference) const {
  const int first = impl_->dynamics.active().first_row.at(contact);
  if (first < 0) return Vector6::Zero();
  const CompiledContact& compiled = impl_->set.contacts()[contact];
  ContactState<double> state = impl_->dynamics.contact_states[contact];
  set_contact_force(compiled, impl_->dynamics.lambda.data() + first, state);
  const auto pose = reference_pose(compile_reference(impl_->model, reference, compiled),
                                   impl_->dynamics.kinematics());
  if (!impl_->has_forces()) return Vector6::Zero();
  const Force<double> force = in_reference(pose, state.force_world);
  Vector6 result;
  result << to_eigen(force.linear), to_eigen(force.angular);
  return result;
}

ContactForce ContactDynamics::force(int contact) const {
  return force(contact, impl_->references.at(to_size(contact)));
}

ContactForce ContactDynamics::force(int contact, const Reference& reference) const {
  const CompiledContact& compiled = impl_->set.contacts().at(contact);
  const ContactState<double>& state = impl_->dynamics.contact_states[contact];
  const Kinematics<double>& kinematics = impl_->dynamics.kinematics();
  const auto base = contact_detail::pose_of<double>(compiled.base_body, compiled.base_R,
                                                    compiled.base_p, kinematics);
  const CompiledReference requested = compile_reference(impl_->model, reference, compiled);
  const Mat3<double> fixed_in = reference_axes(requested, requested.fixed_in, kinematics);
  Reference now = reference;
  if (now.quadric) {  // replaces the surface by fixed axes: its axes at the tool
    now.quadric.reset();
    now.rotation = to_eigen(transpose_times(fixed_in, reference_pose(requested, kinematics).R));
  }
  return {compiled.spec.name,
          compiled.spec.tool,
          compiled.spec.base,
          now,
          wrench(contact, reference),
          to_eigen(state.tool_R),
          to_eigen(base.R),
          to_eigen(state.p),
          to_eigen(base.p),
          to_eigen(fixed_in),
          to_eigen(reference_origin(requested, kinematics))};
}

ContactForce ContactDynamics::force(const std::string& contact) const {
  return force(impl_->set.index(contact));
}

void ContactDynamics::wrench_derivatives(int contact, const Reference& reference,
                                         WrenchDerivatives& out) const {
  if (impl_->evaluated != Evaluation::Forward || !impl_->differentiated)
    throw Error(
        "wrench_derivatives: forward_derivatives() was not called since the last evaluation or "
        "change of contacts; wanted forward(), then forward_derivatives()");
  const int nv = impl_->nv;
  for (RowMatrix* matrix : {&out.dq, &out.dv, &out.dtau}) {
    if (matrix->rows() != 6 || matrix->cols() != nv) matrix->resize(6, nv);
    matrix->setZero();
  }
  const int first = impl_->dynamics.active().first_row.at(contact);
  if (first < 0) return;
  const CompiledContact& compiled = impl_->set.contacts()[contact];
  ContactState<double> state = impl_->dynamics.contact_states[contact];
  const Kinematics<double>& kinematics = impl_->dynamics.kinematics();
  set_contact_force(compiled, impl_->dynamics.lambda.data() + first, state);
  const CompiledReference requested = compile_reference(impl_->model, reference, compiled);
  const auto pose = reference_pose(requested, kinematics);
  wrench_entries(impl_->dynamics.tree(), compiled, requested, impl_->entries);
  // Returns the world wrench that belongs to the derivative of lambda in column k of `stacked`.
  const auto change = [&](const std::vector<double>& stacked, int k) {
    double column[6];
    for (std::size_t r = 0; r < compiled.directions.size(); ++r)
      column[r] = stacked[(nv + first + static_cast<int>(r)) * nv + k];
    ContactState<double> changed = state;
    set_contact_force(compiled, column, changed);
    return changed.force_world;
  };
  const auto store = [](RowMatrix& matrix, int k, const Force<double>& force) {
    matrix.col(k) << to_eigen(force.linear), to_eigen(force.angular);
  };
  auto next = impl_->entries.begin();
  for (int k = 0; k < nv; ++k) {
    const bool moves = next != impl_->entries.end() && next->v == k;
    const WrenchEntry entry = moves ? *next++ : WrenchEntry{k, {}, {}};
    store(
        out.dq, k,
        wrench_rate(compiled, pose, entry, state, kinematics, change(impl_->derivatives.d_dq, k)));
    const ContactSupport pushed{k, entry.tool_axis, entry.base_axis};
    store(out.dv, k,
          wrench_rate_by_v(compiled, pose, pushed, state, kinematics,
                           change(impl_->derivatives.d_dv, k)));
    store(out.dtau, k, in_reference(pose, change(impl_->derivatives.d_dtau, k)));
  }
}

}  // namespace burnish
