// Elements of MJCF with what their default classes say beside them.
#pragma once

#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/mjcf_source.hpp"

namespace burnish::mjcf {

/// A default class: what elements have that do not say otherwise. A class knows what the one around
/// it says.
struct DefaultClass {
  std::string name;
  const DefaultClass* around = nullptr;
  /// Elements by what they are defaults of; of two that state the same the later counts.
  std::map<std::string, std::vector<const XMLElement*>, std::less<>> elements;
};

/// Actuators of every kind share their defaults, and so do tendons.
std::string_view default_kind(std::string_view element);

class DefaultClasses {
 public:
  DefaultClasses();
  /// A <default> of the model's own, with those inside. Throws Error where a class has no name, or
  /// a name that is taken.
  void read(const XMLElement& section, Source& source);

  /// The <default>s of another model, whose classes are renamed; its outermost goes by `main` too,
  /// and knows nothing of the classes of this one.
  void attach(const std::string& main, const std::vector<const XMLElement*>& sections,
              Source& source);

  const DefaultClass& main() const { return classes_.front(); }
  /// Throws Error with the nearest known name.
  const DefaultClass& named(const std::string& name, const XMLElement& asking) const;

 private:
  void read(const XMLElement& element, Source& source, DefaultClass& into);

  std::list<DefaultClass> classes_;  // none of them moves
  std::map<std::string, DefaultClass*, std::less<>> by_name_;
};

/// An element under its class: what it states itself goes first, then its class, then the classes
/// around that.
class Item {
 public:
  Item(const XMLElement& xml, const DefaultClass* defaults);
  /// Where the element's name does not say whose defaults it has.
  Item(const XMLElement& xml, const DefaultClass* defaults, std::string_view kind);

  const XMLElement& xml() const { return *xml_; }
  const DefaultClass* defaults() const { return defaults_; }
  std::string name() const { return text("name").value_or(""); }

  /// The element that states an attribute, or nullptr.
  const XMLElement* stating(const char* attribute) const;
  std::optional<std::string> text(const char* attribute) const;

  /// Exactly `count` numbers, where stated.
  std::optional<std::vector<double>> numbers(const char* attribute, std::size_t count) const;
  double number(const char* attribute, double otherwise) const;
  /// As many of the numbers as are stated go before those that the classes state, and those before
  /// `otherwise`; more than it has are passed over.
  std::vector<double> overlaid(const char* attribute, std::vector<double> otherwise) const;
  bool flag(const char* attribute, bool otherwise) const;
  /// Of true, false and auto: nothing for auto.
  std::optional<bool> choice(const char* attribute) const;

 private:
  void overlay(const DefaultClass* from, const char* attribute, std::vector<double>& onto) const;

  const XMLElement* xml_;
  const DefaultClass* defaults_;  // nullptr: none apply
  std::string_view kind_;
};

}  // namespace burnish::mjcf
