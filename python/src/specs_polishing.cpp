#include "specs_polishing.hpp"

namespace burnish::python {

using namespace polishing;

template <>
const SpecTable& AsDataclass<NamedExperiment>::table() {
  static const SpecTable fields = SpecTable("burnish.polishing", "Experiment")
                                      .field("name", &NamedExperiment::name)
                                      .field("summary", &NamedExperiment::summary);
  return fields;
}

}  // namespace burnish::python
