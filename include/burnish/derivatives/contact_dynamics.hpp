// The door to contact dynamics: one state at a time, Eigen in, Eigen out, nothing allocated after
// construction.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/contact/contact_force.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/model/inertia.hpp"

namespace burnish {

/// Derivatives of a wrench in a reference: (6, nv) each, force rows first.
/// @described derivatives @result
struct WrenchDerivatives {
  RowMatrix dq;  ///< N/rad (N/m), Nm/rad (Nm/m), by the right tangent increment of q
  RowMatrix dv;
  RowMatrix dtau;  ///< [1/m] (force per torque), dimensionless (moment per torque)
};

/// Derivatives by the mass distributions of chosen bodies: ten columns per body, in the order of
/// the bodies and of inertia_parameter_names.
struct InertiaDerivatives {
  RowMatrix a;       ///< nv rows
  RowMatrix lambda;  ///< rows()
};

/// Dynamics of a robot in contact, with all derivatives (eqs. 1 to 6 and 30 to 32 of the paper).
///
/// Conventions: M a + b = tau + J^T lambda; linear part of motions and forces first; d/dq is with
/// respect to the right increment q (+) dq of nv entries; rows of lambda, alpha and J are those of
/// the active contacts, in the order of the set. Views stay valid while the object lives and hold
/// the result of the last call that fills them.
///
/// Results belong to the last evaluation: forward(), inverse() or acceleration(). Views that it
/// does not fill keep older results, which may belong to another state and to other rows: lambda()
/// after acceleration(), tau() and dtau_dq() after forward(), and derivatives until they are
/// computed again. Functions reject older results: derivatives return NotEvaluated,
/// wrench_derivatives() throws Error, and forces are zero. Python rejects all of them.
///
/// Evaluations return a Status and throw nothing; results of a status above NotConverged are zero,
/// except for WrongSize and NotEvaluated, which leave them as they were.
class ContactDynamics {
 public:
  /// Compiles the contacts against the model; throws Error as ContactSet does.
  explicit ContactDynamics(const Model& model, const std::vector<ContactSpec>& contacts = {},
                           const ContactSolver& solver = {});
  ~ContactDynamics();
  ContactDynamics(ContactDynamics&&) noexcept;
  ContactDynamics& operator=(ContactDynamics&&) noexcept;

  const ContactSet& contacts() const;
  int nv() const;
  int rows() const;  ///< of the active contacts
  /// Makes or breaks a contact. Does not allocate. Throws Error for an unknown index.
  void set_active(int contact, bool active);
  bool is_active(int contact) const;
  /// Another rotation in the place of that of a contact's reference, for states evaluated from then
  /// on. Does not allocate. Returns Ok, or NotNormalized for what is no rotation matrix to 1e-6,
  /// which changes nothing. Throws Error for an unknown index.
  Status set_reference_rotation(int contact, const Eigen::Matrix3d& rotation);
  /// Another surface, in the axes of the base, in the place of the one that a contact's reference
  /// follows (Reference::on), likewise: NotFinite for one that holds a NaN or an infinity, which
  /// changes nothing. Throws Error for an unknown index and a reference that follows none.
  Status set_surface(int contact, const Quadric& surface);
  /// Another coefficient of a contact's friction, likewise: NotFinite for one that is no number of
  /// at least zero. Throws Error for an unknown index and a contact without friction.
  Status set_friction(int contact, double coefficient);
  /// What the robot carries at a frame from now on, in the frame's axes: its body's mass
  /// distribution is the model's and this one, in the place of what that body carried before; a
  /// mass of 0 puts it down. For states evaluated from then on. Does not allocate. Returns Ok, or
  /// NotFinite or NotPhysical as check_inertia() does, which changes nothing. Throws Error with the
  /// nearest known name for a frame that there is not, and for one that is fixed to the world.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  /// Names of the active rows, such as "pad/z".
  std::vector<std::string> row_names() const;

  /// Fills a, lambda, mass_matrix, bias, jacobian. q: nq, v: nv, tau: nv (Nm, N).
  Status forward(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau);
  /// Fills the six derivative blocks of a and lambda, at the last forward().
  Status forward_derivatives();

  /// Fills tau = M a + b - J^T lambda. a: nv, lambda: rows().
  Status inverse(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& a,
                 const ConstVectorRef& lambda);
  /// Fills dtau_dq and dtau_dv at the last inverse(); dtau/da is mass_matrix(), dtau/dlambda is
  /// -jacobian()^T (Proposition 4).
  Status inverse_derivatives();

  /// Fills alpha, the contact acceleration J a + alpha_0 plus kd nu + kp e. a: nv.
  Status acceleration(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& a);
  /// Fills dalpha_dq and dalpha_dv at the last acceleration(); dalpha/da is jacobian()
  /// (Proposition 3).
  Status acceleration_derivatives();

  /// The regressor of inverse dynamics at the last forward() or inverse(): with the parameters
  /// theta of all bodies (inertia_parameters), M a + b = Y theta + diag(armature) a. Y is nv x 10
  /// per body, `bodies` being numbers of joints of the model; `out` is resized on first use. Throws
  /// Error for a body that there is not.
  Status regressor(std::span<const int> bodies, RowMatrix& out);
  /// Derivatives of a and lambda by those parameters at the torques of the last forward(), whose
  /// forward_derivatives() were made: d(a, lambda)/dtheta = -d(a, lambda)/dtau Y.
  Status inertia_derivatives(std::span<const int> bodies, InertiaDerivatives& out);

  VectorView a() const;            ///< nv, rad/s^2 or m/s^2
  VectorView lambda() const;       ///< rows, N or Nm
  VectorView tau() const;          ///< nv, Nm or N
  VectorView alpha() const;        ///< rows, m/s^2 or rad/s^2
  VectorView bias() const;         ///< nv, b(q, v)
  MatrixView mass_matrix() const;  ///< nv x nv, armature included
  MatrixView jacobian() const;     ///< rows x nv

  MatrixView da_dq() const;         ///< nv x nv
  MatrixView da_dv() const;         ///< nv x nv
  MatrixView da_dtau() const;       ///< nv x nv
  MatrixView dlambda_dq() const;    ///< rows x nv
  MatrixView dlambda_dv() const;    ///< rows x nv
  MatrixView dlambda_dtau() const;  ///< rows x nv
  MatrixView dtau_dq() const;       ///< nv x nv
  MatrixView dtau_dv() const;       ///< nv x nv
  MatrixView dalpha_dq() const;     ///< rows x nv
  MatrixView dalpha_dv() const;     ///< rows x nv

  /// Velocity nu and pose error e of the active rows at the last state.
  VectorView contact_velocity() const;
  VectorView contact_error() const;

  /// The status of the last evaluation in one sentence that names what is to blame: the joints that
  /// move no mass, the contact rows that cannot be held. Allocates.
  std::string explanation() const;

  /// Proximal iterations of the last forward() and the contact acceleration they left, m/s^2.
  int proximal_iterations() const;
  double proximal_residual() const;
  /// Contact acceleration of the active rows that no force can meet at the last forward(), m/s^2 or
  /// rad/s^2: redundant rows that contradict each other, found by proximal iterations. The status
  /// is then NotConverged, lambda() the least-squares forces, of least norm, and all derivatives
  /// are theirs. Zeros otherwise.
  VectorView unmet() const;

  /// The force of an active contact at the last forward(), or of the lambda that the last inverse()
  /// was given, in the contact's own reference. After anything else there is none: zero, which
  /// Python refuses. Allocates strings; inside a tick use wrench().
  ContactForce force(int contact) const;
  ContactForce force(const std::string& contact) const;
  /// In any other. Throws Error with the nearest known name where that names no frame of the robot,
  /// as the two below do.
  ContactForce force(int contact, const Reference& reference) const;
  /// The same as numbers: force, then moment.
  Vector6 wrench(int contact, const Reference& reference) const;
  /// Its derivatives at the last forward_derivatives(); `out` is resized on first use. Throws Error
  /// unless those are of the last evaluation.
  void wrench_derivatives(int contact, const Reference& reference, WrenchDerivatives& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
