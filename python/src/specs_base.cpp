#include "specs_base.hpp"

namespace burnish::python {

template <>
const EnumTable& AsEnum<Status>::table() {
  static const EnumTable words("burnish.base", "Status",
                               {"ok", "not_converged", "singular_contacts", "singular_mass",
                                "not_normalized", "not_finite", "wrong_size", "not_evaluated"});
  return words;
}

}  // namespace burnish::python
