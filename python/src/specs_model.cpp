#include "specs_model.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<RobotOverrides>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "RobotOverrides")
                                      .field("base", &RobotOverrides::base)
                                      .field("locked", &RobotOverrides::locked)
                                      .field("free", &RobotOverrides::free)
                                      .field("carrying", &RobotOverrides::carrying)
                                      .field("posture", &RobotOverrides::posture)
                                      .field("srdf", &RobotOverrides::srdf)
                                      .field("strict", &RobotOverrides::strict);
  return fields;
}

}  // namespace burnish::python
