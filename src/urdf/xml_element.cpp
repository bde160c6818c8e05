#include "urdf/xml_element.hpp"

#include <algorithm>
#include <cmath>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> result;
  std::size_t begin = text.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    result.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return result;
}

std::string tag(const tinyxml2::XMLElement& element) {
  return std::string("<").append(element.Name()).append(">");
}

[[noreturn]] void refuse_attribute(const tinyxml2::XMLElement& element, const char* attribute,
                                   const XmlPlace& place, const std::string& wanted) {
  refuse(place, element,
         tag(element) + " has " + attribute + " = " + in_quotes(element.Attribute(attribute)) +
             "; " + wanted);
}

std::vector<double> read_numbers(const tinyxml2::XMLElement& element, const char* attribute,
                                 const XmlPlace& place, bool may_be_infinite) {
  std::vector<double> values;
  for (const std::string_view word : words(element.Attribute(attribute))) {
    const std::optional<double> value = parse_number(word);
    if (!value) {
      const bool is_xacro = word.find("${") != std::string_view::npos;
      refuse_attribute(element, attribute, place,
                       in_quotes(word) + " is not a number" +
                           (is_xacro ? "; expand the file with xacro first" : ""));
    }
    const bool allowed = std::isfinite(*value) || (may_be_infinite && !std::isnan(*value));
    if (!allowed) refuse_attribute(element, attribute, place, "wanted finite numbers");
    values.push_back(*value);
  }
  return values;
}

}  // namespace

void refuse(const XmlPlace& place, const tinyxml2::XMLElement& at, const std::string& what) {
  refuse(place.source, line_text(at) + place.element + ": " + what);
}

int line_of(const tinyxml2::XMLElement& element) {
  const auto* original = static_cast<const tinyxml2::XMLElement*>(element.GetUserData());
  return (original == nullptr ? element : *original).GetLineNum();
}

std::string line_text(const tinyxml2::XMLElement& element) {
  return "line " + std::to_string(line_of(element)) + ": ";
}

std::string name_of(const tinyxml2::XMLElement& element, const std::string& source) {
  const char* name = element.Attribute("name");
  if (name != nullptr && *name != '\0') return name;
  refuse(source,
         line_text(element) + tag(element) + " has no name; the attribute 'name' is needed");
}

const tinyxml2::XMLElement* first_child(const tinyxml2::XMLElement& parent, const char* name,
                                        const XmlPlace& place, Findings& findings) {
  const tinyxml2::XMLElement* child = parent.FirstChildElement(name);
  if (child != nullptr && child->NextSiblingElement(name) != nullptr)
    findings.warn(line_text(*child) + place.element + ": " + tag(parent) + " holds " + tag(*child) +
                  " twice; the first one counts");
  return child;
}

const tinyxml2::XMLElement& needed_child(const tinyxml2::XMLElement& parent, const char* name,
                                         const XmlPlace& place) {
  const tinyxml2::XMLElement* child = parent.FirstChildElement(name);
  if (child == nullptr) {
    refuse(place, parent, tag(parent) + " has no <" + name + ">; the element is needed");
  }
  if (child->NextSiblingElement(name) != nullptr) {
    refuse(place, *child, tag(parent) + " holds " + tag(*child) + " twice; wanted it once");
  }
  return *child;
}

std::string needed_attribute(const tinyxml2::XMLElement& element, const char* name,
                             const XmlPlace& place) {
  const char* text = element.Attribute(name);
  if (text == nullptr || *text == '\0') {
    refuse(place, element,
           tag(element) + " has no " + in_quotes(name) + "; the attribute is needed");
  }
  return text;
}

std::optional<std::vector<double>> numbers(const tinyxml2::XMLElement& element,
                                           const char* attribute, std::size_t count,
                                           const XmlPlace& place, bool may_be_infinite) {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return std::nullopt;
  std::vector<double> values = read_numbers(element, attribute, place, may_be_infinite);
  if (values.size() == count) return values;
  refuse_attribute(element, attribute, place,
                   "wanted " + std::to_string(count) + (count == 1 ? " number" : " numbers"));
}

std::vector<double> all_numbers(const tinyxml2::XMLElement& element, const char* attribute,
                                const XmlPlace& place) {
  needed_attribute(element, attribute, place);
  return read_numbers(element, attribute, place, false);
}

double needed_number(const tinyxml2::XMLElement& element, const char* attribute,
                     const XmlPlace& place) {
  needed_attribute(element, attribute, place);
  return numbers(element, attribute, 1, place)->front();
}

}  // namespace burnish
