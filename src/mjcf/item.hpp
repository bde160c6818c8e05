// MJCF elements together with the attributes of their default classes.
#pragma once

#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/mjcf_source.hpp"

namespace burnish::mjcf {

/// Default class: attribute values for elements that do not state them. A class inherits from the
/// enclosing class `around`.
struct DefaultClass {
  std::string name;
  const DefaultClass* around = nullptr;
  /// Default elements by kind. If several of one kind state an attribute, the last one counts.
  std::map<std::string, std::vector<const XMLElement*>, std::less<>> elements;
};

/// Returns the kind of an element in <default>. All actuators are one kind, and so are all tendons.
std::string_view default_kind(std::string_view element);

class DefaultClasses {
 public:
  DefaultClasses();
  /// Reads a <default> of the main model and the classes inside it. Throws Error if a class has no
  /// name or a name that already exists.
  void read(const XMLElement& section, Source& source);

  /// Reads the <default>s of another model, whose classes are already renamed. `main` becomes a
  /// second name of that model's outermost class. No class inherits from the main model's classes.
  void attach(const std::string& main, const std::vector<const XMLElement*>& sections,
              Source& source);

  const DefaultClass& main() const { return classes_.front(); }
  /// Returns a class by name. Throws Error with the nearest name if the class does not exist.
  const DefaultClass& named(const std::string& name, const XMLElement& asking) const;

 private:
  void read(const XMLElement& element, Source& source, DefaultClass& into);

  std::list<DefaultClass> classes_;  // A list, because pointers to its entries must stay valid
  std::map<std::string, DefaultClass*, std::less<>> by_name_;
};

/// Element with its default class. The element's own attributes have priority, then the class, then
/// the enclosing classes.
class Item {
 public:
  Item(const XMLElement& xml, const DefaultClass* defaults);
  /// Sets the kind of defaults for elements whose name does not determine it.
  Item(const XMLElement& xml, const DefaultClass* defaults, std::string_view kind);

  const XMLElement& xml() const { return *xml_; }
  const DefaultClass* defaults() const { return defaults_; }
  std::string name() const { return text("name").value_or(""); }

  /// Returns the element (own or of a class) that states an attribute; nullptr if there is none.
  const XMLElement* stating(const char* attribute) const;
  std::optional<std::string> text(const char* attribute) const;

  /// Returns exactly `count` numbers, if the attribute is stated.
  std::optional<std::vector<double>> numbers(const char* attribute, std::size_t count) const;
  double number(const char* attribute, double otherwise) const;
  /// Returns as many numbers as `otherwise` has. Each number comes from the first list that is long
  /// enough: the element's own, then those of its classes (inner before outer), then `otherwise`.
  std::vector<double> overlaid(const char* attribute, std::vector<double> otherwise) const;
  bool flag(const char* attribute, bool otherwise) const;
  /// Returns true or false; nothing for auto or if the attribute is not stated.
  std::optional<bool> choice(const char* attribute) const;

 private:
  void overlay(const DefaultClass* from, const char* attribute, std::vector<double>& onto) const;

  const XMLElement* xml_;
  const DefaultClass* defaults_;  // nullptr: no defaults
  std::string_view kind_;
};

}  // namespace burnish::mjcf
