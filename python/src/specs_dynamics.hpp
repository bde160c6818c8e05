// Conversion of the types of the dynamics layer between Python and C++. Origin and axes of a
// reference are texts, in the format of Anchor.
#pragma once

#include "burnish/dynamics/reference.hpp"
#include "contact/descriptions.gen.hpp"
#include "specs_base.hpp"
#include "specs_model.hpp"

namespace burnish::python {

template <>
struct SpecOf<Reference> : AsDataclass<Reference> {};
template <>
const SpecTable& AsDataclass<Reference>::table();  // declared before the caster below uses it

}  // namespace burnish::python

namespace pybind11::detail {

template <>
struct type_caster<burnish::Anchor> {
  PYBIND11_TYPE_CASTER(burnish::Anchor, const_name("str"));
  bool load(handle from, bool convert) {
    make_caster<std::string> text;
    if (!text.load(from, convert)) return false;
    value = burnish::Anchor::parse(cast_op<std::string&>(text));
    return true;
  }
  static handle cast(const burnish::Anchor& from, return_value_policy, handle) {
    return pybind11::cast(from.text()).release();
  }
};

/// Reads the dataclass, or a name for Reference::parse().
template <>
struct type_caster<burnish::Reference> {
  PYBIND11_TYPE_CASTER(burnish::Reference, const_name("Reference"));
  bool load(handle from, bool convert) {
    static_cast<void>(&burnish::python::is_known_spec<burnish::Reference>);
    make_caster<std::string> word;
    if (!word.load(from, convert))
      return burnish::python::spec_table<burnish::Reference>().load(from, &value);
    value = burnish::Reference::parse(cast_op<std::string&>(word));
    return true;
  }
  static handle cast(const burnish::Reference& from, return_value_policy, handle) {
    return burnish::python::spec_table<burnish::Reference>().make(&from).release();
  }
};

}  // namespace pybind11::detail
