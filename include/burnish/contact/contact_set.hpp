// Contacts compiled for a model, and options for computing contact forces.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Tolerance for the linear independence of contact rows (rows of the contact Jacobian). A row is
/// independent if its part orthogonal to all rows before it is long enough. The minimum length is
/// about this fraction of the largest motion along the row that the joints could produce at any
/// posture. The tolerance exceeds rounding errors in robot files, such as 5e-7 for six decimals.
inline constexpr double independence_tolerance = 1e-6;

/// Options for computing contact forces from the KKT system: compliance and proximal iterations.
/// @described contact
/// The system is eq. (3) of Kleff et al. (docs/frames.md).
struct ContactSolver {
  /// Compliance of the contact rows (0: rigid contacts), >= 0 @more Rigid contacts need independent
  /// rows; compliant contacts do not. The compliance mu is in m/s^2 per unit force. The lower right
  /// block of the KKT matrix is -mu times the identity.
  double mu = 0.0;
  /// Maximum number of proximal iterations (0: none), >= 0 @more Proximal iterations remove the
  /// effect of the compliance mu on the solution. Each iteration computes lambda <- G^-1 (rho + mu
  /// lambda), where G lambda = rho is the compliant system.
  int max_proximal_iterations = 0;
  /// Contact acceleration error at which proximal iterations stop [m/s^2], >= 0 @more The error of
  /// a row is |mu (lambda - previous lambda)|. Proximal iterations stop once the errors of all rows
  /// are at most this tolerance.
  double proximal_tolerance = 1e-9;

  /// Throws Error if an option is negative or not finite. The message names the option.
  void check() const;
};

/// Constants of one contact, prepared for numerical kernels.
struct CompiledContact;

/// Maximum number of contacts in a set. Memory grows with the square of the number of contact rows.
/// The duration of computations grows with the cube of this number.
inline constexpr std::size_t max_contacts = 100;

/// Immutable set of contacts, compiled for one model. The contacts, and the rows of active
/// contacts, are in the order of the constructor's argument.
class ContactSet {
 public:
  ContactSet();  ///< Set without contacts

  /// Compiles `specs` for `model`. Throws Error if a contact is not valid. The message names the
  /// contact, the value and the requirement. For an unknown frame, it also names the nearest known
  /// frame.
  ContactSet(const Model& model, const std::vector<ContactSpec>& specs);

  int size() const { return size_; }
  int rows() const { return rows_; }
  /// Returns the specifications of the contacts. Each empty name is replaced by the name of the
  /// tool frame.
  std::vector<ContactSpec> specs() const;
  /// Returns the index of the contact `name`. For an unknown name, throws Error with the nearest
  /// known name.
  int index(const std::string& name) const;
  /// Returns the name of each row, such as "pad/z".
  std::vector<std::string> row_names() const;
  /// Compiled contacts, for the numerical kernels.
  const std::vector<CompiledContact>& contacts() const { return *contacts_; }

 private:
  std::shared_ptr<const std::vector<CompiledContact>> contacts_;
  int size_ = 0, rows_ = 0;
};

}  // namespace burnish
