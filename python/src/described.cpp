// Conversion of described structs to dataclasses, by the descriptions of their entries.
#include "bind.hpp"
#include "spec.hpp"

namespace burnish::python {
namespace {

using Kind = ValueType::Kind;

const EntryTraits& carried_as(const ValueType& type) {
  const auto found = carried().find(type.id);
  if (found == carried().end())
    throw Error(std::string("nothing carries a ") + type.id.name() + " to Python: see carry()");
  return found->second;
}

std::string wanted_of(const ValueType& type) {
  switch (type.kind) {
    case Kind::Number:
      return wanted<double>();
    case Kind::Count:
      return wanted<int>();
    case Kind::Flag:
      return wanted<bool>();
    case Kind::Text:
      return wanted<std::string>();
    case Kind::Word: {
      std::string text = "one of";
      for (const std::string& word : type.words().list()) text += " '" + word + "'";
      return text;
    }
    case Kind::Array:
      return wanted_array(type.rows, type.columns);
    case Kind::List:
      return "a list, each entry " + wanted_of(type.element());
    case Kind::Map:
      return "a dict of names, each entry " + wanted_of(type.element());
    case Kind::Optional:
      return wanted_of(type.element()) + ", or None";
    case Kind::Struct:
      return type.description().name;
    case Kind::Other:
      break;
  }
  return carried_as(type).wanted();
}

bool is_flat(const ValueType& type) { return type.rows == 1 || type.columns == 1; }

py::object get_value(const ValueType& type, void* at);

py::object get_array(const ValueType& type, void* at) {
  using Eigen::MatrixXd, Eigen::VectorXd;
  const Eigen::Index rows = type.rows_of(at), columns = type.columns_of(at);
  const Eigen::Map<const MatrixXd> numbers(type.numbers(at), rows, columns);
  if (is_flat(type)) return py::cast(VectorXd(numbers.reshaped()));
  if (type.by_rows)
    return py::cast(MatrixXd(Eigen::Map<const RowMatrix>(numbers.data(), rows, columns)));
  return py::cast(MatrixXd(numbers));
}

py::object get_list(const ValueType& type, void* at) {
  py::list result;
  for (std::size_t i = 0; i < type.size(at); ++i)
    result.append(get_value(type.element(), type.entry(at, i)));
  return result;
}

py::object get_map(const ValueType& type, void* at) {
  py::dict result;
  for (std::size_t i = 0; i < type.size(at); ++i)
    result[py::str(type.name(at, i))] = get_value(type.element(), type.entry(at, i));
  return result;
}

py::object get_value(const ValueType& type, void* at) {
  switch (type.kind) {
    case Kind::Number:
      return py::float_(*static_cast<const double*>(at));
    case Kind::Count:
      if (type.is_unsigned) return py::int_(static_cast<std::uint64_t>(type.get(at)));
      return py::int_(type.get(at));
    case Kind::Flag:
      return py::bool_(*static_cast<const bool*>(at));
    case Kind::Text:
      return py::str(*static_cast<const std::string*>(at));
    case Kind::Word:
      return table_of(type.words()).make(static_cast<int>(type.get(at)));
    case Kind::Array:
      return get_array(type, at);
    case Kind::List:
      return get_list(type, at);
    case Kind::Map:
      return get_map(type, at);
    case Kind::Optional:
      return type.size(at) == 0 ? py::none() : get_value(type.element(), type.entry(at, 0));
    case Kind::Struct:
      return table_of(type.description()).make(at);
    case Kind::Other:
      break;
  }
  return carried_as(type).get(at);
}

bool set_value(const ValueType& type, void* at, py::handle from);

bool set_count(const ValueType& type, void* at, py::handle from) {
  if (type.is_unsigned) {
    py::detail::make_caster<std::uint64_t> caster;
    if (!caster.load(from, true)) return false;
    type.set(at, static_cast<std::int64_t>(py::detail::cast_op<std::uint64_t>(caster)));
    return true;
  }
  py::detail::make_caster<std::int64_t> caster;
  if (!caster.load(from, true)) return false;
  const auto value = py::detail::cast_op<std::int64_t>(caster);
  type.set(at, value);
  return type.get(at) == value;  // false for a value that the type of the member cannot represent
}

bool set_array(const ValueType& type, void* at, py::handle from) {
  py::detail::make_caster<Eigen::VectorXd> flat;
  py::detail::make_caster<Eigen::MatrixXd> matrix;
  Eigen::MatrixXd numbers;
  if (is_flat(type)) {
    if (!flat.load(from, true)) return false;
    numbers = py::detail::cast_op<Eigen::VectorXd&>(flat);
    if (type.rows == 1 && type.columns != 1) numbers.transposeInPlace();
  } else {
    if (!matrix.load(from, true)) return false;
    numbers = py::detail::cast_op<Eigen::MatrixXd&>(matrix);
  }
  if ((type.rows >= 0 && numbers.rows() != type.rows) ||
      (type.columns >= 0 && numbers.cols() != type.columns))
    return false;
  type.resize_array(at, numbers.rows(), numbers.cols());
  if (type.by_rows)
    Eigen::Map<RowMatrix>(type.numbers(at), numbers.rows(), numbers.cols()) = numbers;
  else
    Eigen::Map<Eigen::MatrixXd>(type.numbers(at), numbers.rows(), numbers.cols()) = numbers;
  return true;
}

bool set_list(const ValueType& type, void* at, py::handle from) {
  if (!py::isinstance<py::sequence>(from) || py::isinstance<py::str>(from) ||
      py::isinstance<py::bytes>(from))
    return false;
  const auto entries = py::reinterpret_borrow<py::sequence>(from);
  type.resize(at, 0);
  type.resize(at, entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (!set_value(type.element(), type.entry(at, i), py::object(entries[i]))) return false;
  return true;
}

bool set_map(const ValueType& type, void* at, py::handle from) {
  if (!py::isinstance<py::dict>(from)) return false;
  type.resize(at, 0);
  for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(from))
    if (!py::isinstance<py::str>(name) ||
        !set_value(type.element(), type.named(at, py::cast<std::string>(name)), value))
      return false;
  return true;
}

bool set_value(const ValueType& type, void* at, py::handle from) {
  switch (type.kind) {
    case Kind::Number:
      return value_set<double>(at, from);
    case Kind::Count:
      return set_count(type, at, from);
    case Kind::Flag:
      return value_set<bool>(at, from);
    case Kind::Text:
      return value_set<std::string>(at, from);
    case Kind::Word: {
      int value = 0;
      if (!table_of(type.words()).load(from, value)) return false;
      type.set(at, value);
      return true;
    }
    case Kind::Array:
      return set_array(type, at, from);
    case Kind::List:
      return set_list(type, at, from);
    case Kind::Map:
      return set_map(type, at, from);
    case Kind::Optional:
      type.resize(at, from.is_none() ? 0 : 1);
      return from.is_none() || set_value(type.element(), type.entry(at, 0), from);
    case Kind::Struct:
      return table_of(type.description()).load(from, at);
    case Kind::Other:
      break;
  }
  return carried_as(type).set(at, from);
}

/// Returns a value as plain Python objects, from which scripts/describe writes defaults.
py::object plain(const ValueType& type, void* at);

py::dict plain_entries(const Description& description, void* spec) {
  py::dict entries;
  for (const Field& field : description.fields)
    entries[py::str(field.name)] = plain(*field.type, field.in(spec));
  return entries;
}

py::object plain(const ValueType& type, void* at) {
  py::list entries;
  switch (type.kind) {
    case Kind::Word:
      return py::str(type.words().words[static_cast<std::size_t>(type.get(at))].word);
    case Kind::Array:
      return get_array(type, at).attr("tolist")();
    case Kind::List:
      for (std::size_t i = 0; i < type.size(at); ++i)
        entries.append(plain(type.element(), type.entry(at, i)));
      return entries;
    case Kind::Map:
      return get_map(type, at);
    case Kind::Optional:
      return type.size(at) == 0 ? py::none() : plain(type.element(), type.entry(at, 0));
    case Kind::Struct:
      return plain_entries(type.description(), at);
    case Kind::Other:
      if (const auto text = carried_as(type).default_of) return py::str(text(at));
      return py::none();
    default:
      return get_value(type, at);
  }
}

}  // namespace

py::dict type_entries(const ValueType& type) {
  static const char* const kinds[] = {"Number", "Count", "Flag",     "Word",   "Text", "Array",
                                      "List",   "Map",   "Optional", "Struct", "Other"};
  py::dict entries;
  entries["kind"] = kinds[static_cast<std::size_t>(type.kind)];
  if (type.kind == Kind::Array) entries["shape"] = py::make_tuple(type.rows, type.columns);
  if (type.kind == Kind::Word) entries["name"] = type.words().name;
  if (type.kind == Kind::Struct) {
    entries["name"] = type.description().name;
    entries["module"] = type.description().layer;
  }
  if (type.kind == Kind::Other) {
    entries["name"] = carried_as(type).annotation;
    entries["default"] = carried_as(type).default_value;
  }
  if (type.element != nullptr) entries["element"] = type_entries(type.element());
  return entries;
}

namespace {

py::dict field_entries(const Field& field) {
  py::dict entries;
  entries["name"] = field.name;
  entries["key"] = field.key;
  entries["unit"] = field.unit();
  entries["meaning"] = field.meaning;
  entries["comment"] = field.comment();
  entries["more"] = field.more;
  entries["text"] = field.text();
  entries["word"] = field.word;
  entries["range"] = field.range.text();
  entries["required"] = field.required;
  entries["type"] = type_entries(*field.type);
  return entries;
}

py::dict description_entries(const Description& description) {
  py::list fields, groups;
  for (const Field& field : description.fields) fields.append(field_entries(field));
  for (const Group& group : description.groups)
    groups.append(py::make_tuple(group.begin, group.key, group.meaning));
  py::dict entries;
  entries["module"] = description.layer;
  entries["name"] = description.name;
  entries["meaning"] = description.meaning;
  entries["is_result"] = description.is_result;
  entries["fields"] = fields;
  entries["groups"] = groups;
  entries["defaults"] = plain_entries(description, to_read(description.defaults.get()));
  return entries;
}

using Descriptions = std::map<std::string, const Description*>;
using Enumerations = std::map<std::string, const Words*>;

void collect(const Description& description, Descriptions& specs, Enumerations& enums);

void collect(const ValueType& type, Descriptions& specs, Enumerations& enums) {
  if (type.element != nullptr) collect(type.element(), specs, enums);
  if (type.kind == Kind::Struct) collect(type.description(), specs, enums);
  if (type.kind == Kind::Word) enums[type.words().layer + "." + type.words().name] = &type.words();
}

void collect(const Description& description, Descriptions& specs, Enumerations& enums) {
  if (!specs.insert({description.layer + "." + description.name, &description}).second) return;
  for (const Field& field : description.fields) collect(*field.type, specs, enums);
}

}  // namespace

std::unordered_map<std::type_index, EntryTraits>& carried() {
  static std::unordered_map<std::type_index, EntryTraits> all;
  return all;
}
std::vector<const Description& (*)()>& known_descriptions() {
  static std::vector<const Description& (*)()> all;
  return all;
}

std::vector<const Words& (*)()>& known_words() {
  static std::vector<const Words& (*)()> all;
  return all;
}

Descriptions described_specs() {
  Descriptions specs;
  Enumerations enums;
  for (const auto description : known_descriptions()) collect(description(), specs, enums);
  return specs;
}
Enumerations described_enums() {
  Descriptions specs;
  Enumerations enums;
  for (const auto description : known_descriptions()) collect(description(), specs, enums);
  for (const auto words : known_words()) enums[words().layer + "." + words().name] = &words();
  return enums;
}

SpecTable::SpecTable(const Description& description)
    : class_("burnish." + description.layer, description.name) {
  for (const burnish::Field& field : description.fields)
    fields_.push_back(
        {field.name,
         [&field] { return (field.number_too ? "a number or " : "") + wanted_of(*field.type); },
         [&field](const void* spec) { return get_value(*field.type, to_read(field.in(spec))); },
         [&field](void* spec, py::handle value) {
           const bool is_number =
               py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value);
           if (!field.number_too || !is_number)
             return set_value(*field.type, field.in(spec), value);
           field.type->resize_array(field.in(spec), 1, 1);
           return set_value(type_of<double>(), field.type->numbers(field.in(spec)), value);
         }});
}

const SpecTable& table_of(const Description& description) {
  static std::unordered_map<const Description*, SpecTable> tables;
  return tables.try_emplace(&description, description).first->second;
}

const EnumTable& table_of(const Words& words) {
  static std::unordered_map<const Words*, EnumTable> tables;
  return tables.try_emplace(&words, "burnish." + words.layer, words.name, words.list())
      .first->second;
}

void bind_described(py::module_& m) {
  m.def(
      "descriptions",
      [] {
        py::list all;
        for (const auto& [name, description] : described_specs())
          all.append(description_entries(*description));
        return all;
      },
      "Returns the descriptions of all dataclasses: entries with type, unit, range, meaning and "
      "default.");
  m.def(
      "enumerations",
      [] {
        py::list all;
        for (const auto& [name, words] : described_enums()) {
          py::list members;
          for (const Words::Word& word : words->words)
            members.append(py::make_tuple(word.word, word.meaning));
          py::dict entries;
          entries["module"] = words->layer;
          entries["name"] = words->name;
          entries["meaning"] = words->meaning;
          entries["members"] = members;
          all.append(entries);
        }
        return all;
      },
      "Returns all enumerations: members in the order of their values, with their meanings.");
}

}  // namespace burnish::python
