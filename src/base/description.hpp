// Description of a specification: its entries with unit, range and meaning. Files and their
// comments, range checks, Python dataclasses and tables of the docs are derived from it.
//
// scripts/describe generates descriptions.gen.cpp from the comments in headers; see
// CONTRIBUTING.md. A struct is described by `const Description& description_of(const Spec*)`, an
// enumeration by `const Words& words_of(Enum)`. The descriptions.gen.hpp of a layer declares both.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <vector>

#include "base/to_size.hpp"

namespace burnish {

/// Allowed range of a number, or of each number of an array.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool open = false;       ///< Excludes both ends
  bool below = false;      ///< Excludes the upper end
  bool infinite = false;   ///< Includes infinity
  bool direction = false;  ///< Allows a vector of any length except zero
  bool holds(double value) const;
  std::string text() const;  ///< Returns a text such as "more than 0"; empty for any number
};

namespace range {
inline constexpr double end = std::numeric_limits<double>::infinity();
inline constexpr Range any{}, not_negative{.least = 0.0}, positive{.least = 0.0, .open = true},
    positive_or_infinite{.least = 0.0, .open = true, .infinite = true},
    not_negative_or_infinite{.least = 0.0, .infinite = true}, share{.least = 0.0, .most = 1.0},
    fraction{.least = 0.0, .most = 1.0, .below = true}, any_or_infinite{.infinite = true},
    direction{.direction = true};
constexpr Range from(double least, double most = end) { return {.least = least, .most = most}; }
constexpr Range above(double least) { return {.least = least, .open = true}; }
constexpr Range between(double least, double most) {
  return {.least = least, .most = most, .open = true};
}
}  // namespace range

/// Description of an enumeration: its words in files, requests and Python. The enumerators must
/// have the values 0, 1, 2, ... in the order of the words.
struct Words {
  struct Word {
    std::string word, meaning = {};
  };
  std::string layer, name, meaning;
  std::vector<Word> words;

  std::vector<std::string> list() const;
  /// Returns the value of `word`. Throws Error with the nearest word if there is no such word.
  int value_of(const std::string& word) const;
};

struct Description;

template <class T>
concept Described = requires(const T* spec) {
  { description_of(spec) } -> std::same_as<const Description&>;
};
template <class T>
concept Worded = std::is_enum_v<T> && requires(T value) {
  { words_of(value) } -> std::same_as<const Words&>;
};

/// Type of an entry, with functions that read and change a value at its address. The comment of a
/// member names the kinds of type for which the member is set.
struct ValueType {
  enum class Kind { Number, Count, Flag, Word, Text, Array, List, Map, Optional, Struct, Other };
  Kind kind = Kind::Other;
  std::type_index id = typeid(void);
  void (*assign)(void* to, const void* from) = nullptr;  ///< Copies a value; null: not copyable
  bool is_unsigned = false;                              ///< Kind Count: unsigned integer
  Eigen::Index rows = 1, columns = 1;                    ///< Kind Array: dimensions; -1: any
  const Words& (*words)() = nullptr;                     ///< Kind Word: words of the enumeration
  const Description& (*description)() = nullptr;         ///< Kind Struct: description
  const ValueType& (*element)() = nullptr;               ///< List, Map, Optional: type of entries
  std::int64_t (*get)(const void*) = nullptr;            ///< Kinds Count, Word: reads value
  void (*set)(void*, std::int64_t) = nullptr;            ///< Kinds Count, Word: writes value
  std::size_t (*size)(const void*) = nullptr;            ///< List, Map: entries; Optional: 0 or 1
  void (*resize)(void*, std::size_t) = nullptr;          ///< List, Optional: any size; Map: only 0
  void* (*entry)(void*, std::size_t) = nullptr;          ///< List, Map, Optional: entry by index
  const std::string& (*name)(const void*, std::size_t) = nullptr;  ///< Kind Map: key of an entry
  void* (*named)(void*, const std::string&) = nullptr;  ///< Kind Map: entry by key, added if absent
  bool by_rows = false;                                 ///< Kind Array: stored row by row
  double* (*numbers)(void*) = nullptr;                  ///< Kind Array: address of the numbers
  Eigen::Index (*rows_of)(const void*) = nullptr;       ///< Kind Array: number of rows
  Eigen::Index (*columns_of)(const void*) = nullptr;
  void (*resize_array)(void*, Eigen::Index, Eigen::Index) = nullptr;
};

/// Removes const from an address. Functions of ValueType that only read a value take a void*.
inline void* to_read(const void* at) {
  return const_cast<void*>(at);  // NOLINT(cppcoreguidelines-pro-type-const-cast): read only
}

/// Description of one entry of a specification.

struct Field {
  std::string name;     ///< Member name in C++ and Python
  std::string key;      ///< Key in files
  std::string meaning;  ///< Text with the unit in braces: "Normal force [{N}]"
  std::string in_code;  ///< Text that replaces `meaning` in docs, Python and C++; or empty
  std::string more;     ///< Further text, left out of the comments in files
  std::string word;     ///< Word in files for an absent or infinite value; or empty
  Range range;
  std::size_t offset = 0;
  const ValueType* type = nullptr;
  /// Kind of object that a text, or each text of a list, must name: "frame", "joint" or "contact".
  /// Empty if any text is allowed.
  std::string name_of = {};
  /// Words that files use for the counts 0, 1, ..., separated by spaces. Empty if files use
  /// numbers.
  std::string words = {};
  bool required = false;    ///< Python: has no default, so users must pass it
  bool stated = false;      ///< Files: the entry must be stated
  bool number_too = false;  ///< Python: one number is also accepted for this vector

  void* in(void* spec) const { return static_cast<char*>(spec) + offset; }
  const void* in(const void* spec) const { return static_cast<const char*>(spec) + offset; }
  std::string unit() const;     ///< Unit of the value; empty: none
  std::string comment() const;  ///< Comment text for files
  std::string text() const;     ///< Full text, `more` included
};

/// Group of entries that belong together: from `begin` up to the next group.
struct Group {
  std::size_t begin;
  std::string key;  ///< Section of a file that contains the entries; or empty
  std::string meaning;
};

/// Description of a specification.
struct Description {
  std::string layer, name, meaning;
  std::vector<Field> fields = {};
  std::vector<Group> groups = {};
  bool is_result = false;  ///< True for output of the library, false for input
  std::shared_ptr<void> (*make)() = nullptr;

  std::shared_ptr<const void> defaults = {};

  const Field& field(const std::string& name_of_field) const;
};

/// Throws Error "<subject> is <value>; wanted <range>" for the first number in `spec` that is NaN
/// or out of range. `subject` turns the path of an entry, such as "pushes[0].duration", into the
/// subject of the message.
void check_ranges(const Description& description, const void* spec,
                  const std::function<std::string(const std::string& entry)>& subject);

/// Overwrites the parts of `spec` that `changes` states: optionals that are set, entries of maps
/// with the same key, and entries of lists of structs with the same `name`. All other entries keep
/// their values, because `changes` does not record whether they are stated.
void put_over(const Description& description, void* spec, const void* changes);

template <class T>
const ValueType& type_of();

namespace detail {

template <class T>
struct Element {};
template <class T>
struct Element<std::vector<T>> {
  using type = T;
};
template <class T>
struct Element<std::optional<T>> {
  using type = T;
};
template <class T>
struct Element<std::map<std::string, T>> {
  using type = T;
};
template <class T>
concept List = std::same_as<T, std::vector<typename Element<T>::type>>;
template <class T>
concept Map = std::same_as<T, std::map<std::string, typename Element<T>::type>>;
template <class T>
concept Optional = std::same_as<T, std::optional<typename Element<T>::type>>;
template <class T>
concept Array =
    std::derived_from<T, Eigen::PlainObjectBase<T>> && std::same_as<typename T::Scalar, double>;

template <class T>
void count(ValueType& type) {
  type.get = [](const void* at) { return static_cast<std::int64_t>(*static_cast<const T*>(at)); };
  type.set = [](void* at, std::int64_t value) { *static_cast<T*>(at) = static_cast<T>(value); };
}
template <class T>
void array(ValueType& type) {
  type.kind = ValueType::Kind::Array;
  type.rows = T::RowsAtCompileTime;
  type.columns = T::ColsAtCompileTime;
  type.by_rows = T::IsRowMajor;
  type.numbers = [](void* at) { return static_cast<T*>(at)->data(); };
  type.rows_of = [](const void* at) { return static_cast<const T*>(at)->rows(); };
  type.columns_of = [](const void* at) { return static_cast<const T*>(at)->cols(); };
  type.resize_array = [](void* at, Eigen::Index rows, Eigen::Index columns) {
    static_cast<T*>(at)->resize(rows, columns);
  };
}
template <class T>
void list(ValueType& type) {
  type.kind = ValueType::Kind::List;
  type.element = &type_of<typename Element<T>::type>;
  type.size = [](const void* at) { return static_cast<const T*>(at)->size(); };
  type.resize = [](void* at, std::size_t size) { static_cast<T*>(at)->resize(size); };
  type.entry = [](void* at, std::size_t i) -> void* { return &(*static_cast<T*>(at))[i]; };
}
template <class T>
void map(ValueType& type) {
  type.kind = ValueType::Kind::Map;
  type.element = &type_of<typename Element<T>::type>;
  type.size = [](const void* at) { return static_cast<const T*>(at)->size(); };
  type.resize = [](void* at, std::size_t) { static_cast<T*>(at)->clear(); };
  type.entry = [](void* at, std::size_t i) -> void* {
    return &std::next(static_cast<T*>(at)->begin(), static_cast<std::ptrdiff_t>(i))->second;
  };
  type.name = [](const void* at, std::size_t i) -> const std::string& {
    return std::next(static_cast<const T*>(at)->begin(), static_cast<std::ptrdiff_t>(i))->first;
  };
  type.named = [](void* at, const std::string& name) -> void* {
    return &(*static_cast<T*>(at))[name];
  };
}
template <class T>
void optional(ValueType& type) {
  type.kind = ValueType::Kind::Optional;
  type.element = &type_of<typename Element<T>::type>;
  type.size = [](const void* at) -> std::size_t { return static_cast<const T*>(at)->has_value(); };
  type.resize = [](void* at, std::size_t size) {
    if (size == 0)
      static_cast<T*>(at)->reset();
    else
      static_cast<T*>(at)->emplace();
  };
  type.entry = [](void* at, std::size_t) -> void* { return &**static_cast<T*>(at); };
}

template <class T>
ValueType make_type() {
  using Kind = ValueType::Kind;
  ValueType type;
  type.id = typeid(T);
  if constexpr (std::is_copy_assignable_v<T>)
    type.assign = [](void* to, const void* from) {
      *static_cast<T*>(to) = *static_cast<const T*>(from);
    };
  if constexpr (std::same_as<T, bool>) {
    type.kind = Kind::Flag;
  } else if constexpr (Worded<T>) {
    type.kind = Kind::Word;
    type.words = []() -> const Words& { return words_of(T{}); };
    count<T>(type);
  } else if constexpr (std::integral<T>) {
    type.kind = Kind::Count;
    type.is_unsigned = std::is_unsigned_v<T>;
    count<T>(type);
  } else if constexpr (std::same_as<T, double>) {
    type.kind = Kind::Number;
  } else if constexpr (std::same_as<T, std::string>) {
    type.kind = Kind::Text;
  } else if constexpr (Array<T>) {
    array<T>(type);
  } else if constexpr (List<T>) {
    list<T>(type);
  } else if constexpr (Map<T>) {
    map<T>(type);
  } else if constexpr (Optional<T>) {
    optional<T>(type);
  } else if constexpr (Described<T>) {
    type.kind = Kind::Struct;
    type.description = []() -> const Description& {
      return description_of(static_cast<const T*>(nullptr));
    };
  }
  return type;  // kind Other: only code that knows the C++ type can handle the value
}

}  // namespace detail

template <class T>
const ValueType& type_of() {
  static const ValueType type = detail::make_type<T>();
  return type;
}

namespace detail {
// Functions that do not depend on the type of the specification and are compiled only once.
void add_field(Description& description, const char* name, const char* means, const Range& numbers,
               std::size_t offset, const ValueType& type);
void add_group(Description& description, const char* means, const char* section);
Field& last_field(Description& description);
void set_text(std::string& of, const char* text);

template <class Spec>
std::shared_ptr<void> made() {
  return std::make_shared<Spec>();
}
}  // namespace detail

/// Builds a Description, entry by entry in the order of the members.
template <class Spec>
class Describe : public Description {
 public:
  Describe(const char* of_layer, const char* of_name, const char* means)
      : Description{of_layer, of_name, means} {
    make = &detail::made<Spec>;
    defaults = make();
  }
  template <class Value, class Owner>
  Describe& field(const char* of_name, Value Owner::*member, const char* means = "",
                  const Range& numbers = range::any) {
    const auto* example = static_cast<const Spec*>(defaults.get());
    const void *begin = example, *at = &(example->*member);
    const auto offset = static_cast<const char*>(at) - static_cast<const char*>(begin);
    detail::add_field(*this, of_name, means, numbers, to_size(offset), type_of<Value>());
    return *this;
  }
  using Description::field;
  // The following functions change the entry that was added last.
  Describe& in_code(const char* text) { return set(&Field::in_code, text); }
  Describe& more(const char* text) { return set(&Field::more, text); }
  Describe& key(const char* text) { return set(&Field::key, text); }
  Describe& word(const char* text) { return set(&Field::word, text); }
  Describe& name_of(const char* text) { return set(&Field::name_of, text); }
  Describe& words(const char* text) { return set(&Field::words, text); }
  Describe& stated() { return detail::last_field(*this).stated = true, *this; }
  Describe& required() { return detail::last_field(*this).required = true, *this; }
  Describe& number_too() { return detail::last_field(*this).number_too = true, *this; }
  /// Begins a group of entries.
  Describe& group(const char* means, const char* section = "") {
    return detail::add_group(*this, means, section), *this;
  }
  Describe& result() { return is_result = true, *this; }

 private:
  Describe& set(std::string Field::*member, const char* text) {
    return detail::set_text(detail::last_field(*this).*member, text), *this;
  }
};

}  // namespace burnish
