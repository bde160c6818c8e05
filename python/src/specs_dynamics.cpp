#include "specs_dynamics.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<Reference>::table() {
  static const SpecTable fields = SpecTable("burnish.contact", "Reference")
                                      .field("origin", &Reference::origin)
                                      .field("axes", &Reference::axes)
                                      .field("rotation", &Reference::rotation)
                                      .field("rotation_over_time", &Reference::rotation_over_time)
                                      .field("quadric", &Reference::quadric);
  return fields;
}

}  // namespace burnish::python
