// Strict reading of XML elements. Errors name missing elements, duplicates and invalid numbers.
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings.hpp"

namespace burnish {

/// Place in a URDF or SRDF file that error messages name: the file, and the link or joint.
struct XmlPlace {
  std::string source;
  std::string element;  ///< Link or joint, such as "link 'arm_3'"
};

/// Throws Error("<source>: line <of the XML element>: <element>: <what>").
[[noreturn]] void refuse(const XmlPlace& place, const tinyxml2::XMLElement& at,
                         const std::string& what);

/// Returns the line of an element. For a copy, whose user data points to the original element,
/// returns the line of the original.
int line_of(const tinyxml2::XMLElement& element);
/// Returns the line of an element as text: "line 12: ".
std::string line_text(const tinyxml2::XMLElement& element);

/// Returns the attribute 'name' of an element. Throws Error if it is missing or empty.
std::string name_of(const tinyxml2::XMLElement& element, const std::string& source);

/// Returns the first child element called `name`, or nullptr. Warns if there are several.
const tinyxml2::XMLElement* first_child(const tinyxml2::XMLElement& parent, const char* name,
                                        const XmlPlace& place, Findings& findings);
/// Returns the child element called `name`. Throws Error if there are none or several.
const tinyxml2::XMLElement& needed_child(const tinyxml2::XMLElement& parent, const char* name,
                                         const XmlPlace& place);

/// Returns the attribute called `name`. Throws Error if it is missing or empty.
std::string needed_attribute(const tinyxml2::XMLElement& element, const char* name,
                             const XmlPlace& place);

/// Returns the numbers of an attribute, or nothing if the attribute is missing. Throws Error for
/// another number of values than `count`, for NaN, and for infinities unless they are allowed.
std::optional<std::vector<double>> numbers(const tinyxml2::XMLElement& element,
                                           const char* attribute, std::size_t count,
                                           const XmlPlace& place, bool may_be_infinite = false);
/// Returns all numbers of an attribute. Throws Error if the attribute is missing or empty, and for
/// numbers that are not finite.
std::vector<double> all_numbers(const tinyxml2::XMLElement& element, const char* attribute,
                                const XmlPlace& place);
/// Returns the number of an attribute. Throws Error if the attribute is missing.
double needed_number(const tinyxml2::XMLElement& element, const char* attribute,
                     const XmlPlace& place);

}  // namespace burnish
