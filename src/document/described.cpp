#include "document/described.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "base/yaml_word.hpp"
#include "document/text.hpp"

namespace burnish::document {
namespace {

using Type = ValueType::Kind;

void check(double value, const Range& range, const Reader& reader) {
  if (!range.holds(value))
    reader.refuse("it is " + burnish::number(value) + "; wanted " + range.text());
}

/// Returns the words that files use in place of the numbers 0, 1, ... of a count.
std::vector<std::string> words_of(const Field& field) {
  std::istringstream text(field.words);
  return {std::istream_iterator<std::string>(text), {}};
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Reads an infinity as YAML (.inf) or C++ (inf) writes it. Returns nothing for any other value.
std::optional<double> infinite(const Reader& reader) {
  for (const char* word : {".inf", "+.inf", "inf", "+inf"})
    if (reader.is(word)) return infinity;
  for (const char* word : {"-.inf", "-inf"})
    if (reader.is(word)) return -infinity;
  return {};
}

void read_array(const Field& field, const ValueType& type, void* at, const Reader& reader) {
  const bool any_size = type.rows < 0;
  const Eigen::VectorXd values = any_size ? reader.numbers() : reader.numbers(type.rows);
  for (const double value : values) check(value, field.range, reader);
  constexpr double min_length = 1e-9;  // chosen by hand
  if (field.range.direction && !(values.norm() > min_length))
    reader.refuse("the " + field.key + " has no direction; wanted " + field.range.text());
  if (any_size) type.resize_array(at, values.size(), 1);
  Eigen::Map<Eigen::VectorXd>(type.numbers(at), values.size()) = values;
}

void read_number(const Field& field, void* at, const Reader& reader, bool is_word) {
  const auto end = field.range.infinite ? infinite(reader) : std::nullopt;
  const double value = is_word ? infinity : end ? *end : reader.number();
  check(value, field.range, reader);
  *static_cast<double*>(at) = value;
}

void read_count(const Field& field, const ValueType& type, void* at, const Reader& reader) {
  if (!field.words.empty()) {
    const std::vector<std::string> words = words_of(field);
    const std::string word = reader.word(words);
    return type.set(at, std::find(words.begin(), words.end(), word) - words.begin());
  }
  constexpr double max_count = 1e9;
  const double min_count = type.is_unsigned ? 0.0 : -max_count;
  const int value = reader.count(static_cast<int>(std::max(field.range.least, min_count)));
  check(value, field.range, reader);
  type.set(at, value);
}

/// Reads values of any described specification.
struct DescribedReader {
  const Reading& reading;

  bool can_read(const ValueType& type) const {
    if (reading.types.contains(type.id)) return true;
    return type.element != nullptr ? can_read(type.element()) : type.kind != Type::Other;
  }

  /// Reads a struct. `all` is set for entries of lists: then every key must be stated, except keys
  /// with a word for an absent value (Field::word).
  void structure(const Description& description, void* spec, const Reader& reader, bool all,
                 const std::vector<std::string>& also = {}) const {
    std::vector<const Field*> fields;
    std::vector<std::string> keys;
    for (const Field& field : description.fields)
      if (can_read(*field.type)) fields.push_back(&field);
    for (const Field* field : fields) keys.push_back(field->key);
    keys.insert(keys.end(), also.begin(), also.end());
    reader.allow_only(keys);
    for (const Field* field : fields)
      if (field->stated || (all && field->word.empty()))
        entry(*field, spec, reader[field->key]);
      else if (const auto stated = reader.find(field->key))
        entry(*field, spec, *stated);
  }

  void entry(const Field& field, void* spec, const Reader& reader) const {
    if (const auto names = reading.names.find(field.name_of); names != reading.names.end())
      names->second(reader);
    value(field, *field.type, field.in(spec), reader);
  }

  void list(const Field& field, const ValueType& type, void* at, const Reader& reader) const {
    type.resize(at, 0);
    if (type.element().kind == Type::Text) {  // one text, or a list of texts
      const std::vector<std::string> texts = reader.texts();
      type.resize(at, texts.size());
      for (std::size_t i = 0; i < texts.size(); ++i)
        *static_cast<std::string*>(type.entry(at, i)) = texts[i];
      return;
    }
    const std::vector<Reader> entries = reader.entries();
    type.resize(at, entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (type.element().kind == Type::Struct)
        structure(type.element().description(), type.entry(at, i), entries[i], true);
      else
        value(field, type.element(), type.entry(at, i), entries[i]);
  }

  void map(const Field& field, const ValueType& type, void* at, const Reader& reader) const {
    type.resize(at, 0);
    for (const auto& [name, stated] : reader.items())
      value(field, type.element(), type.named(at, name), stated);
  }

  void value(const Field& field, const ValueType& type, void* at, const Reader& reader) const {
    if (const auto own = reading.types.find(type.id); own != reading.types.end())
      return own->second(at, reader);
    const bool is_word = !field.word.empty() && reader.is(field.word);
    switch (type.kind) {
      case Type::Number:
        return read_number(field, at, reader, is_word);
      case Type::Count:
        return read_count(field, type, at, reader);
      case Type::Flag:
        *static_cast<bool*>(at) = reader.yes_or_no();
        return;
      case Type::Word:
        return type.set(at, type.words().value_of(reader.word(type.words().list())));
      case Type::Text:
        *static_cast<std::string*>(at) = is_word ? std::string() : reader.text();
        return;
      case Type::Array:
        if (!is_word) return read_array(field, type, at, reader);
        if (type.rows < 0) return type.resize_array(at, 0, 1);
        Eigen::Map<Eigen::VectorXd>(type.numbers(at), type.rows).setZero();
        return;
      case Type::List:
        if (!is_word) return list(field, type, at, reader);
        type.resize(at, 1);  // stores the word as the only entry of a list of texts
        *static_cast<std::string*>(type.entry(at, 0)) = field.word;
        return;
      case Type::Map:
        return map(field, type, at, reader);
      case Type::Optional:
        type.resize(at, is_word ? 0 : 1);
        if (!is_word) value(field, type.element(), type.entry(at, 0), reader);
        return;
      case Type::Struct:
        return structure(type.description(), at, reader, false);
      case Type::Other:
        break;
    }
    reader.refuse("it cannot be stated in a file");
  }
};

std::string value_text(const Field& field, const ValueType& type, void* at);

std::string struct_text(const Description& description, const void* spec) {
  std::string text;
  for (const Field& field : description.fields)
    if (const auto value = entry_text(field, spec))
      text += (text.empty() ? "{" : ", ") + field.key + ": " + *value;
  return text + "}";
}

std::string list_text(const Field& field, const ValueType& type, void* at) {
  if (!field.word.empty() && type.element().kind == Type::Text && type.size(at) == 1 &&
      *static_cast<const std::string*>(type.entry(at, 0)) == field.word)
    return field.word;
  std::string text;
  for (std::size_t i = 0; i < type.size(at); ++i)
    text += (i == 0 ? "" : ", ") + value_text(field, type.element(), type.entry(at, i));
  return "[" + text + "]";
}

std::string map_text(const Field& field, const ValueType& type, void* at) {
  std::string text;
  for (std::size_t i = 0; i < type.size(at); ++i)
    text += (i == 0 ? "" : ", ") + yaml_word(type.name(at, i)) + ": " +
            value_text(field, type.element(), type.entry(at, i));
  return "{" + text + "}";
}

std::string array_text(const ValueType& type, void* at) {
  std::string text;
  const double* numbers = type.numbers(at);
  for (Eigen::Index i = 0; i < type.rows_of(at); ++i)
    text += (i == 0 ? "" : ", ") + number_text(numbers[i]);
  return "[" + text + "]";
}

std::string value_text(const Field& field, const ValueType& type, void* at) {
  switch (type.kind) {
    case Type::Number: {
      const double value = *static_cast<const double*>(at);
      return std::isinf(value) && !field.word.empty() ? field.word : number_text(value);
    }
    case Type::Count:
      if (!field.words.empty()) return words_of(field)[to_size(type.get(at))];
      return std::to_string(type.get(at));
    case Type::Flag:
      return *static_cast<const bool*>(at) ? "true" : "false";
    case Type::Word:
      return type.words().words[to_size(type.get(at))].word;
    case Type::Text:
      return yaml_word(*static_cast<const std::string*>(at));
    case Type::Array:
      return type.rows_of(at) == 0 && !field.word.empty() ? field.word : array_text(type, at);
    case Type::List:
      return list_text(field, type, at);
    case Type::Map:
      return map_text(field, type, at);
    case Type::Optional:
      return type.size(at) == 0 ? field.word : value_text(field, type.element(), type.entry(at, 0));
    case Type::Struct:
      return struct_text(type.description(), at);
    case Type::Other:
      break;
  }
  return "";
}

}  // namespace

void read_entry(const Field& field, void* spec, const Reader& reader) {
  const Reading reading;
  DescribedReader{reading}.entry(field, spec, reader);
}

void read_described(const Description& description, void* spec, const Reader& reader,
                    const Reading& reading) {
  DescribedReader{reading}.structure(description, spec, reader, false, reading.also);
}

std::optional<std::string> entry_text(const Field& field, const void* spec) {
  // ValueType takes void*, but the functions below only read the value.
  void* at = const_cast<void*>(field.in(spec));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  if (field.type->kind == Type::Text && static_cast<const std::string*>(at)->empty()) {
    if (field.word.empty()) return std::nullopt;
    return field.word;
  }
  return value_text(field, *field.type, at);
}

}  // namespace burnish::document
