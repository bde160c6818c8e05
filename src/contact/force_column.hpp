// Column names of contact forces in tables.
#pragma once

#include <string>

#include "burnish/contact/contact.hpp"

namespace burnish {

/// Returns a column name such as "table_force_z_centered" or "foot_moment_x_local".
inline std::string force_column(const ContactSpec& contact, int direction) {
  const char axis = "xyz"[direction % 3];
  return (contact.name.empty() ? contact.tool : contact.name) +
         (direction < 3 ? "_force_" : "_moment_") + axis + "_" + contact.reference.name();
}

}  // namespace burnish
