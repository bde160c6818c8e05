#include "specs_derivatives.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<CheckOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.derivatives", "CheckOptions")
                                      .field("tool", &CheckOptions::tool)
                                      .field("base", &CheckOptions::base)
                                      .field("references", &CheckOptions::references)
                                      .field("surfaces", &CheckOptions::surfaces)
                                      .field("directions", &CheckOptions::directions)
                                      .field("accelerations", &CheckOptions::accelerations)
                                      .field("gains", &CheckOptions::gains)
                                      .field("contacts", &CheckOptions::contacts)
                                      .field("states", &CheckOptions::states)
                                      .field("seed", &CheckOptions::seed)
                                      .field("tolerance", &CheckOptions::tolerance)
                                      .field("progress", &CheckOptions::progress);
  return fields;
}

}  // namespace burnish::python
