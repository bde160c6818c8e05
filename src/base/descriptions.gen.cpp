// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "base/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(Status /*of*/) {
  static const Words all{
      "base",
      "Status",
      "Outcome of an evaluation, ordered by severity. If several outcomes apply, the most severe "
      "outcome is returned.",
      {{"ok"},
       {"not_converged", "Proximal iterations ended at their maximum number, before the tolerance was reached"},
       {"singular_contacts", "Contact constraints are redundant or not controllable, and their compliance mu is 0"},
       {"singular_mass", "Mass matrix is not positive definite at this configuration"},
       {"not_normalized", "Length of a quaternion or (cos, sin) pair differs from 1 by over 1e-6"},
       {"not_physical", "Mass distribution that no solid can have"},
       {"not_finite", "Input has a NaN or an infinity, or is so large that the result overflows"},
       {"wrong_size", "Argument has the wrong number of entries"},
       {"not_evaluated", "Derivatives were requested without the evaluation that they belong to"}}};
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
