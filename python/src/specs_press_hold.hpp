// Values of the task press_hold and its runs.
#pragma once

#include "press_hold/descriptions.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"

namespace burnish::python {

template <>
struct SpecOf<press_hold::Setting> : AsDataclass<press_hold::Setting> {};
template <>
struct SpecOf<press_hold::RunSpec> : AsDataclass<press_hold::RunSpec> {};
template <>
struct SpecOf<press_hold::HoldFigures> : AsDataclass<press_hold::HoldFigures> {};

}  // namespace burnish::python
