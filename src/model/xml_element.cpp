#include "model/xml_element.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "burnish/base/error.hpp"
#include "model/parse_number.hpp"
#include "model/sentence.hpp"

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

std::string plain(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  // printf follows the locale's decimal separator; the readers that follow do not.
  std::replace(text, text + sizeof text, ',', '.');
  return text;
}

}  // namespace

void refuse(const XmlPlace& place, const std::string& what) {
  refuse(place.source, place.element + ": " + what);
}

tinyxml2::XMLElement* only_child(tinyxml2::XMLElement& parent, const char* name,
                                 const XmlPlace& place) {
  tinyxml2::XMLElement* child = parent.FirstChildElement(name);
  if (child != nullptr && child->NextSiblingElement(name) != nullptr) {
    refuse(place, tag(parent) + " holds " + tag(*child) + " twice; wanted it once");
  }
  return child;
}

tinyxml2::XMLElement& needed_child(tinyxml2::XMLElement& parent, const char* name,
                                   const XmlPlace& place) {
  tinyxml2::XMLElement* child = only_child(parent, name, place);
  if (child == nullptr) {
    refuse(place, tag(parent) + " has no <" + name + ">; it must hold one");
  }
  return *child;
}

std::string needed_attribute(const tinyxml2::XMLElement& element, const char* name,
                             const XmlPlace& place) {
  const char* text = element.Attribute(name);
  if (text == nullptr || *text == '\0') {
    refuse(place, tag(element) + " has no " + in_quotes(name) + "; the attribute is needed");
  }
  return text;
}

std::optional<std::vector<double>> numbers(tinyxml2::XMLElement& element, const char* attribute,
                                           std::size_t count, const XmlPlace& place,
                                           bool may_be_infinite) {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return std::nullopt;
  const auto wrong = [&](const std::string& wanted) {
    refuse(place, tag(element) + " has " + attribute + " = " + in_quotes(text) + "; " + wanted);
  };
  std::vector<double> values;
  std::string rewritten;
  for (const std::string_view word : words(text)) {
    const std::optional<double> value = parse_number(word);
    if (!value) wrong(in_quotes(word) + " is not a number");
    const bool allowed = std::isfinite(*value) || (may_be_infinite && !std::isnan(*value));
    if (!allowed) wrong("it must be finite");
    values.push_back(*value);
    rewritten += (rewritten.empty() ? "" : " ") + plain(*value);
  }
  if (values.size() != count) {
    wrong("wanted " + std::to_string(count) + (count == 1 ? " number" : " numbers"));
  }
  element.SetAttribute(attribute, rewritten.c_str());
  return values;
}

double needed_number(tinyxml2::XMLElement& element, const char* attribute, const XmlPlace& place) {
  needed_attribute(element, attribute, place);
  return numbers(element, attribute, 1, place)->front();
}

void keep_children(tinyxml2::XMLElement& parent, std::initializer_list<std::string_view> names) {
  tinyxml2::XMLElement* child = parent.FirstChildElement();
  while (child != nullptr) {
    tinyxml2::XMLElement* next = child->NextSiblingElement();
    const bool keep = std::find(names.begin(), names.end(), child->Name()) != names.end();
    if (!keep) parent.DeleteChild(child);
    child = next;
  }
}

}  // namespace burnish
