// Conversion of values between Python dataclasses and C++ structs, by their descriptions or tables
// of fields. Values are copied: Python can copy, pickle, compare, print and change its own values.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <unordered_map>
#include <vector>

#include "arrays.hpp"
#include "base/description.hpp"
#include "burnish/base/error.hpp"

namespace burnish::python {

namespace py = pybind11;

class SpecTable;
class EnumTable;

/// Name of a type without namespaces, as in signatures of pybind11.
template <class T>
constexpr std::string_view type_name() {
  constexpr std::string_view text = __PRETTY_FUNCTION__;
  constexpr std::size_t begin = text.find("T = ") + 4;
  constexpr std::string_view whole = text.substr(begin, text.find_first_of(";]", begin) - begin);
  constexpr std::size_t colon = whole.rfind(':');
  return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}
template <class T>
struct TypeName {
  static constexpr std::size_t size = type_name<T>().size();
  struct Text {
    char letters[size + 1] = {};
  };
  static constexpr Text text = [] {
    Text copy;
    for (std::size_t i = 0; i < size; ++i) copy.letters[i] = type_name<T>()[i];
    return copy;
  }();
  static constexpr auto name = py::detail::descr<size>(text.letters);
};

/// Base of SpecOf<T> for a struct T that is a dataclass in Python, but is not marked @described in
/// its header. SpecOf<T> must be declared before the first binding that uses T. table() must be
/// defined in the specs_*.cpp of the layer of T. EnumOf does the same for enumerations.
template <class T>
struct AsDataclass : TypeName<T> {
  static const SpecTable& table();
};
template <class T>
struct AsEnum : TypeName<T> {
  static const EnumTable& table();
};
template <class T>
struct SpecOf {};
template <class T>
struct EnumOf {};

template <class T>
concept IsSpec = Described<T> || std::is_base_of_v<AsDataclass<T>, SpecOf<T>>;
template <class T>
concept IsEnum = Worded<T> || std::is_base_of_v<AsEnum<T>, EnumOf<T>>;

/// Returns a type as plain Python objects, for scripts/describe.
py::dict type_entries(const ValueType& type);
const SpecTable& table_of(const Description& description);
const EnumTable& table_of(const Words& words);
template <IsSpec T>
const SpecTable& spec_table() {
  if constexpr (Described<T>)
    return table_of(description_of(static_cast<const T*>(nullptr)));
  else
    return SpecOf<T>::table();
}
template <IsEnum T>
const EnumTable& enum_table() {
  if constexpr (Worded<T>)
    return table_of(words_of(T{}));
  else
    return EnumOf<T>::table();
}

/// Python class of a dataclass or enumeration, looked up on first use.
class PythonClass {
 public:
  PythonClass(std::string module, std::string name)
      : module_(std::move(module)), name_(std::move(name)) {}
  const std::string& name() const { return name_; }
  std::string full_name() const { return module_ + "." + name_; }
  py::handle get() const;

 private:
  std::string module_, name_;
  mutable py::handle class_ = {};  // never released, as it lives as long as the interpreter
};

/// Enumeration with the values 0, 1, 2, ...
class EnumTable {
 public:
  EnumTable(std::string module, std::string name, std::vector<std::string> words)
      : class_(std::move(module), std::move(name)), words_(std::move(words)) {}
  const std::vector<std::string>& words() const { return words_; }
  std::string full_name() const { return class_.full_name(); }
  /// Reads a member of the enumeration, or the name of a member as text. Returns false for another
  /// type. Throws Error for an unknown name.
  bool load(py::handle from, int& value) const;
  py::object make(int value) const;

 private:
  PythonClass class_;
  std::vector<std::string> words_;             ///< Names in lower case
  mutable std::vector<py::handle> members_{};  ///< Members, looked up once and never released
};

/// Returns a text about the values that a field accepts, for error messages.
template <class Value>
std::string wanted();

/// Conversions between a struct and its dataclass, for tests of all structs.
struct KnownSpec {
  const SpecTable& (*table)();
  py::object (*make_default)();             ///< Makes a dataclass with default values
  py::object (*round_trip)(py::handle of);  ///< Converts a dataclass to the struct and back
};
/// Lists of the types that bindings use: structs and enumerations without descriptions, then with.
std::vector<KnownSpec>& known_specs();
std::vector<const EnumTable& (*)()>& known_enums();
std::vector<const Description& (*)()>& known_descriptions();
std::vector<const Words& (*)()>& known_words();
/// Described structs and their entries, by "layer.Name".
std::map<std::string, const Description*> described_specs();
std::map<std::string, const Words*> described_enums();

/// Conversion of an entry of a type that descriptions do not support.
struct EntryTraits {
  const char* annotation;                  ///< Annotation in Python
  const char* default_value;               ///< Default in Python; "": none
  std::string (*default_of)(const void*);  ///< Value as Python code; null: default_value
  std::string (*wanted)();
  py::object (*get)(const void*);
  bool (*set)(void*, py::handle);
};
std::unordered_map<std::type_index, EntryTraits>& carried();

template <class Value>
py::object value_get(const void* at) {
  if constexpr (py::detail::is_pyobject<Value>::value)
    return *static_cast<const Value*>(at);
  else
    return py::cast(*static_cast<const Value*>(at), py::return_value_policy::copy);
}
template <class Value>
bool value_set(void* at, py::handle from) {
  py::detail::make_caster<Value> caster;
  if (!caster.load(from, true)) return false;
  // Copies the value, because the caster can return an object that Python keeps using.
  const Value& loaded = py::detail::cast_op<Value&>(caster);
  *static_cast<Value*>(at) = loaded;
  return true;
}

class SpecTable {
 public:
  /// `module` must have the dataclass `name`.
  SpecTable(const char* module, const char* name) : class_(module, name) {}
  explicit SpecTable(const Description& description);

  template <class Spec, class Value>
  SpecTable& field(const char* name, Value Spec::*member) {
    fields_.push_back({name, wanted<Value>,
                       [member](const void* spec) {
                         return value_get<Value>(&(static_cast<const Spec*>(spec)->*member));
                       },
                       [member](void* spec, py::handle value) {
                         return value_set<Value>(&(static_cast<Spec*>(spec)->*member), value);
                       }});
    return *this;
  }

  /// Adds an entry that C++ stores in another form, with functions that read and write the entry.
  /// When `set` is called, the entries added before are already set.
  template <class Spec>
  SpecTable& field(const char* name, std::string (*what_is_wanted)(),
                   py::object (*get)(const Spec& spec), bool (*set)(Spec& spec, py::handle value)) {
    fields_.push_back(
        {name, what_is_wanted,
         [get](const void* spec) { return get(*static_cast<const Spec*>(spec)); },
         [set](void* spec, py::handle value) { return set(*static_cast<Spec*>(spec), value); }});
    return *this;
  }

  /// Returns false if `from` is not an instance of the dataclass. Throws Error with the name of an
  /// invalid field.
  bool load(py::handle from, void* spec) const;
  py::object make(const void* spec) const;
  std::string full_name() const { return class_.full_name(); }

 private:
  struct Field {
    std::string name;
    std::function<std::string()> wanted;
    std::function<py::object(const void*)> get;
    std::function<bool(void*, py::handle)> set;
  };
  PythonClass class_;
  std::vector<Field> fields_;
};

template <class>
inline constexpr bool is_vector = false;
template <class Value>
inline constexpr bool is_vector<std::vector<Value>> = true;
template <class>
inline constexpr bool is_optional = false;
template <class Value>
inline constexpr bool is_optional<std::optional<Value>> = true;

/// Adds a struct to known_descriptions() or known_specs() when the module is loaded.
template <class Spec>
inline const bool is_known_spec = [] {
  if constexpr (Described<Spec>)
    known_descriptions().push_back(
        []() -> const Description& { return description_of(static_cast<const Spec*>(nullptr)); });
  else
    known_specs().push_back({&SpecOf<Spec>::table,
                             [] {
                               const Spec spec{};
                               return SpecOf<Spec>::table().make(&spec);
                             },
                             [](py::handle of) {
                               Spec spec{};
                               if (!SpecOf<Spec>::table().load(of, &spec)) return py::object();
                               return SpecOf<Spec>::table().make(&spec);
                             }});
  return true;
}();
template <class Enum>
inline const bool is_known_enum = [] {
  if constexpr (Worded<Enum>)
    known_words().push_back([]() -> const Words& { return words_of(Enum{}); });
  else
    known_enums().push_back(&EnumOf<Enum>::table);
  return true;
}();
/// Registers a type of entry that descriptions do not support. Must be called once for each type.
template <class Value>
bool carry(const char* annotation, const char* default_value = "",
           std::string (*default_of)(const void*) = nullptr) {
  return carried()
      .insert({typeid(Value),
               {annotation, default_value, default_of, [] { return wanted<Value>(); },
                value_get<Value>, value_set<Value>}})
      .second;
}

std::string wanted_array(Eigen::Index rows, Eigen::Index columns);  ///< -1 means any size

template <class Value>
std::string wanted() {
  if constexpr (IsEnum<Value>) {
    std::string text = "one of";
    for (const std::string& word : enum_table<Value>().words()) text += " '" + word + "'";
    return text;
  } else if constexpr (std::is_same_v<Value, bool>) {
    return "True or False";
  } else if constexpr (std::is_integral_v<Value>) {
    return "a whole number";
  } else if constexpr (std::is_floating_point_v<Value>) {
    return "a number";
  } else if constexpr (std::is_same_v<Value, std::string>) {
    return "a text";
  } else if constexpr (std::is_base_of_v<Eigen::PlainObjectBase<Value>, Value>) {
    return wanted_array(Value::RowsAtCompileTime, Value::ColsAtCompileTime);
  } else if constexpr (is_vector<Value>) {
    return "a list, each entry " + wanted<typename Value::value_type>();
  } else if constexpr (is_optional<Value>) {
    return wanted<typename Value::value_type>() + ", or None";
  } else if constexpr (std::is_base_of_v<py::detail::type_caster_generic,
                                         py::detail::make_caster<Value>>) {
    return "a " +
           std::string(type_name<Value>());  // for a bound class, whose caster has no name yet
  } else {
    return py::detail::make_caster<Value>::name.text;
  }
}

}  // namespace burnish::python

namespace pybind11::detail {

template <class T>
struct type_caster<T, std::enable_if_t<burnish::python::IsSpec<T>>> {
  PYBIND11_TYPE_CASTER(T, burnish::python::TypeName<T>::name);
  bool load(handle from, bool) {
    static_cast<void>(&burnish::python::is_known_spec<T>);
    return burnish::python::spec_table<T>().load(from, &value);
  }
  static handle cast(const T& from, return_value_policy, handle) {
    static_cast<void>(&burnish::python::is_known_spec<T>);
    return burnish::python::spec_table<T>().make(&from).release();
  }
};

template <class T>
struct type_caster<T, std::enable_if_t<burnish::python::IsEnum<T>>> {
  PYBIND11_TYPE_CASTER(T, burnish::python::TypeName<T>::name);
  bool load(handle from, bool) {
    static_cast<void>(&burnish::python::is_known_enum<T>);
    int number = 0;
    if (!burnish::python::enum_table<T>().load(from, number)) return false;
    value = static_cast<T>(number);
    return true;
  }
  static handle cast(T from, return_value_policy, handle) {
    static_cast<void>(&burnish::python::is_known_enum<T>);
    return burnish::python::enum_table<T>().make(static_cast<int>(from)).release();
  }
};

}  // namespace pybind11::detail
