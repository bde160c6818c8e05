// Reading XML elements strictly: what is missing, written twice or no number is named.
#pragma once

#include <tinyxml2.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// Where a sentence points: the file, and the link or joint that is being read.
struct XmlPlace {
  std::string source;
  std::string element;  ///< e.g. "link 'arm_3'"
};

/// Throws Error("<source>: <element>: <what>").
[[noreturn]] void refuse(const XmlPlace& place, const std::string& what);

/// The child of that name, or nullptr; two of them are refused.
tinyxml2::XMLElement* only_child(tinyxml2::XMLElement& parent, const char* name,
                                 const XmlPlace& place);
tinyxml2::XMLElement& needed_child(tinyxml2::XMLElement& parent, const char* name,
                                   const XmlPlace& place);

/// A non-empty attribute.
std::string needed_attribute(const tinyxml2::XMLElement& element, const char* name,
                             const XmlPlace& place);

/// Reads `count` numbers of an attribute and writes them back in plain notation, so that no later
/// reader can take them differently. Nothing if the attribute is missing. NaN is refused, and so
/// are infinities unless allowed.
std::optional<std::vector<double>> numbers(tinyxml2::XMLElement& element, const char* attribute,
                                           std::size_t count, const XmlPlace& place,
                                           bool may_be_infinite = false);
double needed_number(tinyxml2::XMLElement& element, const char* attribute, const XmlPlace& place);

/// Deletes child elements whose names are not listed.
void keep_children(tinyxml2::XMLElement& parent, std::initializer_list<std::string_view> names);

}  // namespace burnish
