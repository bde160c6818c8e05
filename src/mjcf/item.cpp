#include "mjcf/item.hpp"

#include <algorithm>
#include <array>

#include "base/sentence.hpp"

namespace burnish::mjcf {

std::string_view default_kind(std::string_view element) {
  constexpr std::array<std::string_view, 13> actuators = {
      "general", "motor",    "position", "velocity", "intvelocity", "damper",     "cylinder",
      "muscle",  "adhesion", "plugin",   "dcmotor",  "pid",         "orientation"};
  if (std::find(actuators.begin(), actuators.end(), element) != actuators.end()) return "actuator";
  if (element == "fixed" || element == "spatial") return "tendon";
  if (element == "connect" || element == "weld") return "equality";
  return element;
}

DefaultClasses::DefaultClasses() {
  classes_.push_back({"main", nullptr, {}});
  by_name_["main"] = &classes_.front();
}

void DefaultClasses::read(const XMLElement& section, Source& source) {
  const char* name = section.Attribute("class");
  if (name != nullptr && *name != '\0') by_name_[name] = &classes_.front();
  read(section, source, classes_.front());
}

void DefaultClasses::attach(const std::string& main, const std::vector<const XMLElement*>& sections,
                            Source& source) {
  classes_.push_back({main, nullptr, {}});
  DefaultClass& outermost = classes_.back();
  by_name_[main] = &outermost;
  for (const XMLElement* section : sections) {
    const char* name = section->Attribute("class");
    if (name != nullptr && *name != '\0') by_name_[name] = &outermost;
    read(*section, source, outermost);
  }
}

void DefaultClasses::read(const XMLElement& element, Source& source, DefaultClass& into) {
  for (const XMLElement* child : source.children(element)) {
    if (std::string_view(child->Name()) != "default") {
      into.elements[std::string(default_kind(child->Name()))].push_back(child);
      continue;
    }
    const std::string name = needed_attribute(*child, "class", place_of(*child));
    if (by_name_.contains(name))
      refuse_at(*child, "class " + in_quotes(name) + " is defined twice");
    classes_.push_back({name, &into, {}});
    by_name_[name] = &classes_.back();
    read(*child, source, classes_.back());
  }
}

const DefaultClass& DefaultClasses::named(const std::string& name, const XMLElement& asking) const {
  const auto found = by_name_.find(name);
  if (found != by_name_.end()) return *found->second;
  std::vector<std::string> known;
  for (const auto& [one, defaults] : by_name_) known.push_back(one);
  refuse_at(asking, "class " + in_quotes(name) + " does not exist" + did_you_mean(name, known));
}

Item::Item(const XMLElement& xml, const DefaultClass* defaults)
    : Item(xml, defaults, default_kind(xml.Name())) {}

Item::Item(const XMLElement& xml, const DefaultClass* defaults, std::string_view kind)
    : xml_(&xml), defaults_(defaults), kind_(kind) {}

const XMLElement* Item::stating(const char* attribute) const {
  if (xml_->Attribute(attribute) != nullptr) return xml_;
  // Names are not inherited from classes.
  if (std::string_view(attribute) == "name") return nullptr;
  for (const DefaultClass* at = defaults_; at != nullptr; at = at->around) {
    const auto stated = at->elements.find(kind_);
    if (stated == at->elements.end()) continue;
    for (auto one = stated->second.rbegin(); one != stated->second.rend(); ++one)
      if ((*one)->Attribute(attribute) != nullptr) return *one;
  }
  return nullptr;
}

std::optional<std::string> Item::text(const char* attribute) const {
  const XMLElement* at = stating(attribute);
  return at == nullptr ? std::nullopt : std::optional<std::string>(at->Attribute(attribute));
}

std::optional<std::vector<double>> Item::numbers(const char* attribute, std::size_t count) const {
  const XMLElement* at = stating(attribute);
  if (at == nullptr) return std::nullopt;
  return burnish::numbers(*at, attribute, count, place_of(*at));
}

double Item::number(const char* attribute, double otherwise) const {
  const auto stated = numbers(attribute, 1);
  return stated ? stated->front() : otherwise;
}

void Item::overlay(const DefaultClass* from, const char* attribute,
                   std::vector<double>& onto) const {
  const auto put = [&](const XMLElement& at) {
    if (at.Attribute(attribute) == nullptr) return;
    const std::vector<double> stated = all_numbers(at, attribute, place_of(at));
    std::copy_n(stated.begin(), std::min(stated.size(), onto.size()), onto.begin());
  };
  std::vector<const DefaultClass*> outermost_first;
  for (; from != nullptr; from = from->around) outermost_first.push_back(from);
  for (auto at = outermost_first.rbegin(); at != outermost_first.rend(); ++at) {
    const auto stated = (*at)->elements.find(kind_);
    if (stated == (*at)->elements.end()) continue;
    for (const XMLElement* one : stated->second) put(*one);
  }
  put(*xml_);
}

std::vector<double> Item::overlaid(const char* attribute, std::vector<double> otherwise) const {
  overlay(defaults_, attribute, otherwise);
  return otherwise;
}

bool Item::flag(const char* attribute, bool otherwise) const {
  return choice(attribute).value_or(otherwise);
}

std::optional<bool> Item::choice(const char* attribute) const {
  const XMLElement* at = stating(attribute);
  if (at == nullptr) return std::nullopt;
  const std::string word = at->Attribute(attribute);
  if (word == "true") return true;
  if (word == "false") return false;
  if (word == "auto") return std::nullopt;
  refuse_at(*at,
            std::string(attribute) + " is " + in_quotes(word) + "; wanted true, false or auto");
}

}  // namespace burnish::mjcf
