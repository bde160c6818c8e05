#include "files/described.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "base/yaml_word.hpp"
#include "document/text.hpp"

namespace burnish::files {
namespace {

using Kind = ValueType::Kind;
using document::number_text;

void check(double value, const Range& range, const Reader& reader) {
  if (!range.holds(value))
    reader.refuse("it is " + burnish::number(value) + "; wanted " + range.text());
}

void read_array(const Field& field, const ValueType& type, void* at, const Reader& reader) {
  const bool any_size = type.rows < 0;
  const Eigen::VectorXd values = any_size ? reader.numbers() : reader.numbers(type.rows);
  for (const double value : values) check(value, field.range, reader);
  constexpr double shortest = 1e-9;
  if (field.range.direction && !(values.norm() > shortest))
    reader.refuse("the " + field.key + " has no direction; wanted " + field.range.text());
  if (any_size) type.resize_array(at, values.size(), 1);
  Eigen::Map<Eigen::VectorXd>(type.numbers(at), values.size()) = values;
}

void read_value(const Field& field, const ValueType& type, void* at, const Reader& reader);

/// Entries of a list state all keys but those that have a word for what they are without.
void read_struct(const Description& description, void* spec, const Reader& reader, bool all) {
  std::vector<std::string> keys;
  for (const Field& field : description.fields)
    if (field.type->kind != Kind::Other) keys.push_back(field.key);
  reader.allow_only(keys);
  for (const Field& field : description.fields)
    if (field.type->kind == Kind::Other)
      continue;
    else if (all && field.word.empty())
      read_entry(field, spec, reader[field.key]);
    else if (const auto value = reader.find(field.key))
      read_entry(field, spec, *value);
}

void read_list(const Field& field, const ValueType& type, void* at, const Reader& reader) {
  const std::vector<Reader> entries = reader.entries();
  type.resize(at, 0);
  type.resize(at, entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (type.element().kind == Kind::Struct)
      read_struct(type.element().description(), type.entry(at, i), entries[i], true);
    else
      read_value(field, type.element(), type.entry(at, i), entries[i]);
}

void read_map(const Field& field, const ValueType& type, void* at, const Reader& reader) {
  type.resize(at, 0);
  for (const auto& [name, value] : reader.items())
    read_value(field, type.element(), type.named(at, name), value);
}

void read_value(const Field& field, const ValueType& type, void* at, const Reader& reader) {
  const bool is_word = !field.word.empty() && reader.is(field.word);
  switch (type.kind) {
    case Kind::Number: {
      const double value = is_word ? range::end : reader.number();
      check(value, field.range, reader);
      *static_cast<double*>(at) = value;
      return;
    }
    case Kind::Count: {
      constexpr double most = 1e9;
      const double least = type.is_unsigned ? 0.0 : -most;
      const int value = reader.count(static_cast<int>(std::max(field.range.least, least)));
      check(value, field.range, reader);
      return type.set(at, value);
    }
    case Kind::Flag:
      *static_cast<bool*>(at) = reader.yes_or_no();
      return;
    case Kind::Word:
      return type.set(at, type.words().value_of(reader.word(type.words().list())));
    case Kind::Text:
      *static_cast<std::string*>(at) = is_word ? std::string() : reader.text();
      return;
    case Kind::Array:
      if (!is_word) return read_array(field, type, at, reader);
      if (type.rows < 0) return type.resize_array(at, 0, 1);
      Eigen::Map<Eigen::VectorXd>(type.numbers(at), type.rows).setZero();
      return;
    case Kind::List:
      if (!is_word) return read_list(field, type, at, reader);
      type.resize(at, 1);  // of texts: the word alone
      *static_cast<std::string*>(type.entry(at, 0)) = field.word;
      return;
    case Kind::Map:
      return read_map(field, type, at, reader);
    case Kind::Optional:
      type.resize(at, is_word ? 0 : 1);
      if (!is_word) read_value(field, type.element(), type.entry(at, 0), reader);
      return;
    case Kind::Struct:
      return read_struct(type.description(), at, reader, false);
    case Kind::Other:
      break;
  }
  reader.refuse("it cannot be stated in a file");
}

std::string value_text(const Field& field, const ValueType& type, void* at);

std::string struct_text(const Description& description, const void* spec) {
  std::string text;
  for (const Field& field : description.fields)
    if (const auto value = entry_text(field, spec))
      text += (text.empty() ? "{" : ", ") + field.key + ": " + *value;
  return text + "}";
}

std::string list_text(const Field& field, const ValueType& type, void* at) {
  if (!field.word.empty() && type.element().kind == Kind::Text && type.size(at) == 1 &&
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
    case Kind::Number: {
      const double value = *static_cast<const double*>(at);
      return std::isinf(value) ? field.word : number_text(value);
    }
    case Kind::Count:
      return std::to_string(type.get(at));
    case Kind::Flag:
      return *static_cast<const bool*>(at) ? "true" : "false";
    case Kind::Word:
      return type.words().words[static_cast<std::size_t>(type.get(at))].word;
    case Kind::Text:
      return yaml_word(*static_cast<const std::string*>(at));
    case Kind::Array:
      return type.rows_of(at) == 0 && !field.word.empty() ? field.word : array_text(type, at);
    case Kind::List:
      return list_text(field, type, at);
    case Kind::Map:
      return map_text(field, type, at);
    case Kind::Optional:
      return type.size(at) == 0 ? field.word : value_text(field, type.element(), type.entry(at, 0));
    case Kind::Struct:
      return struct_text(type.description(), at);
    case Kind::Other:
      break;
  }
  return "";
}

}  // namespace

void read_entry(const Field& field, void* spec, const Reader& reader) {
  read_value(field, *field.type, field.in(spec), reader);
}

void read_described(const Description& description, void* spec, const Reader& reader) {
  read_struct(description, spec, reader, false);
}

std::optional<std::string> entry_text(const Field& field, const void* spec) {
  // What gives access to a value's parts takes it as one that may be written; nothing is.
  void* at = const_cast<void*>(field.in(spec));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  if (field.type->kind == Kind::Text && static_cast<const std::string*>(at)->empty()) {
    if (field.word.empty()) return std::nullopt;
    return field.word;
  }
  return value_text(field, *field.type, at);
}

}  // namespace burnish::files
