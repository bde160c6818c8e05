// Conversion of the types of the contact layer between Python and C++. Directions are texts such as
// "z,rx,ry".
#pragma once

#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_force.hpp"
#include "burnish/contact/contact_set.hpp"
#include "contact/descriptions.gen.hpp"
#include "specs_dynamics.hpp"

namespace pybind11::detail {

template <>
struct type_caster<burnish::Directions> {
  PYBIND11_TYPE_CASTER(burnish::Directions, const_name("str"));
  bool load(handle from, bool convert) {
    make_caster<std::string> text;
    if (!text.load(from, convert)) return false;
    value = burnish::Directions::parse(cast_op<std::string&>(text));
    return true;
  }
  static handle cast(const burnish::Directions& from, return_value_policy, handle) {
    return pybind11::cast(from.text()).release();
  }
};

}  // namespace pybind11::detail
