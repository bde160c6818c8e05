// Contacts compiled against a model, and how their system is solved.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// A row of a contact counts as held where more than this part of what could have been moves along
/// it that the rows before it do not hold: angles of a file with six decimals are right to 5e-7.
inline constexpr double independence_tolerance = 1e-6;

/// The KKT system of eq. (3) and its relaxation.
/// @described contact
struct ContactSolver {
  /// Compliance, the lower right block -mu 1 of the KKT matrix. 0: the exact system, which needs
  /// independent rows. Positive: any rows, m/s^2 per unit force. >= 0
  double mu = 0.0;
  /// With mu > 0: refinements lambda <- G^-1 (rho + mu lambda), at most; they remove the compliance
  /// while it lasts. 0 keeps the compliant solution. >= 0
  int max_proximal_iterations = 0;
  /// The iterations stop when every |mu (lambda - previous)| <= this, m/s^2: what is left of the
  /// contact acceleration. >= 0
  double proximal_tolerance = 1e-9;

  /// Throws Error with a sentence naming the option that is negative or not finite.
  void check() const;
};

/// Constants of one contact, as the kernels read them.
struct CompiledContact;

/// Of one model: memory and time grow with the square and the cube of their rows.
inline constexpr std::size_t max_contacts = 100;

/// Contacts of a model, in the order given. Immutable; rows of contact i start at first_row(i) when
/// every contact is active.
class ContactSet {
 public:
  ContactSet();  ///< without contacts
  /// Throws Error with one sentence naming the contact, what came and what was wanted (unknown
  /// frame: the nearest known one).
  ContactSet(const Model& model, const std::vector<ContactSpec>& specs);

  int size() const { return size_; }
  int rows() const { return rows_; }
  /// As they were given, all named.
  std::vector<ContactSpec> specs() const;
  /// Index by name. Throws Error with the nearest known name.
  int index(const std::string& name) const;
  /// Name of each row, such as "pad/z".
  std::vector<std::string> row_names() const;
  /// For kernels.
  const std::vector<CompiledContact>& contacts() const { return *contacts_; }

 private:
  std::shared_ptr<const std::vector<CompiledContact>> contacts_;
  int size_ = 0, rows_ = 0;
};

}  // namespace burnish
