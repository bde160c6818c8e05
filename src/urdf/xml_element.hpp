// Reading XML elements strictly: what is missing, written twice or no number is named.
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings.hpp"

namespace burnish {

/// Where a sentence points: the file, and the link or joint that is being read.
struct XmlPlace {
  std::string source;
  std::string element;  ///< e.g. "link 'arm_3'"
};

/// Throws Error("<source>: line <of the XML element>: <element>: <what>").
[[noreturn]] void refuse(const XmlPlace& place, const tinyxml2::XMLElement& at,
                         const std::string& what);

/// The line it stands at; of a copy, whose user data is what it was copied from, that one's.
int line_of(const tinyxml2::XMLElement& element);
/// "line 12: ".
std::string line_text(const tinyxml2::XMLElement& element);

/// The attribute 'name' of a link, a joint or a material, which needs one.
std::string name_of(const tinyxml2::XMLElement& element, const std::string& source);

/// The first child of that name, or nullptr; a warning says that there are others.
const tinyxml2::XMLElement* first_child(const tinyxml2::XMLElement& parent, const char* name,
                                        const XmlPlace& place, Findings& findings);
/// The child of that name; two of them are refused.
const tinyxml2::XMLElement& needed_child(const tinyxml2::XMLElement& parent, const char* name,
                                         const XmlPlace& place);

/// A non-empty attribute.
std::string needed_attribute(const tinyxml2::XMLElement& element, const char* name,
                             const XmlPlace& place);

/// The `count` numbers of an attribute; nothing if the attribute is missing. NaN is refused, and so
/// are infinities unless allowed.
std::optional<std::vector<double>> numbers(const tinyxml2::XMLElement& element,
                                           const char* attribute, std::size_t count,
                                           const XmlPlace& place, bool may_be_infinite = false);
/// All numbers of an attribute that is needed, one at least.
std::vector<double> all_numbers(const tinyxml2::XMLElement& element, const char* attribute,
                                const XmlPlace& place);
double needed_number(const tinyxml2::XMLElement& element, const char* attribute,
                     const XmlPlace& place);

}  // namespace burnish
