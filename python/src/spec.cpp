#include "spec.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "bind.hpp"

namespace burnish::python {

namespace {

std::string small(std::string word) {
  for (char& letter : word)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

/// Returns a short text of a Python object, for messages.
std::string shown(py::handle value) {
  std::string text = py::repr(value);
  constexpr std::size_t longest = 60;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

}  // namespace

py::handle PythonClass::get() const {
  if (!class_)
    class_ = py::object(py::module_::import(module_.c_str()).attr(name_.c_str())).release();
  return class_;
}

bool EnumTable::load(py::handle from, int& value) const {
  if (py::isinstance(from, class_.get())) {
    value = py::cast<int>(from.attr("value"));
    return true;
  }
  if (!py::isinstance<py::str>(from)) return false;
  const auto word = py::cast<std::string>(from);
  const auto found = std::find(words_.begin(), words_.end(), small(word));
  if (found == words_.end())
    throw Error(class_.name() + ": there is no '" + word + "'" + did_you_mean(small(word), words_));
  value = static_cast<int>(found - words_.begin());
  return true;
}

py::object EnumTable::make(int value) const {
  if (members_.empty()) {
    std::vector<py::handle> members;
    for (int i = 0; i < static_cast<int>(words_.size()); ++i)
      members.push_back(py::reinterpret_borrow<py::object>(class_.get())(i).release());
    members_ = std::move(members);
  }
  return py::reinterpret_borrow<py::object>(members_.at(static_cast<std::size_t>(value)));
}

bool SpecTable::load(py::handle from, void* spec) const {
  if (!py::isinstance(from, class_.get())) return false;
  for (const Field& field : fields_) {
    const py::object value = from.attr(field.name.c_str());
    if (!field.set(spec, value))
      throw Error(class_.name() + "." + field.name + ": got " + shown(value) + "; wanted " +
                  field.wanted());
  }
  return true;
}

py::object SpecTable::make(const void* spec) const {
  py::dict values;
  for (const Field& field : fields_) values[py::str(field.name)] = field.get(spec);
  return py::reinterpret_borrow<py::object>(class_.get())(**values);
}

std::vector<KnownSpec>& known_specs() {
  static std::vector<KnownSpec> all;
  return all;
}
std::vector<const EnumTable& (*)()>& known_enums() {
  static std::vector<const EnumTable& (*)()> all;
  return all;
}

namespace {

KnownSpec known_spec(const std::string& name) {
  std::vector<std::string> names;
  for (const KnownSpec& spec : known_specs()) {
    names.push_back(spec.table().full_name());
    if (names.back() == name) return spec;
  }
  throw Error("there is no dataclass '" + name + "'" + did_you_mean(name, names));
}

/// Returns the description of the dataclass burnish.layer.Name; null if the dataclass has none.
const Description* described(const std::string& name) {
  const auto specs = described_specs();
  const auto found = specs.find(name.substr(std::min(name.size(), std::string("burnish.").size())));
  return found == specs.end() ? nullptr : found->second;
}

}  // namespace

void bind_specs(py::module_& m) {
  m.def(
      "spec_names",
      [] {
        std::vector<std::string> names;
        for (const KnownSpec& spec : known_specs()) names.push_back(spec.table().full_name());
        for (const auto& [name, description] : described_specs())
          names.push_back("burnish." + name);
        return names;
      },
      "Returns the names of dataclasses with a C++ struct, such as 'burnish.contact.ContactSpec'.");
  m.def(
      "spec_default",
      [](const std::string& name) {
        if (const Description* description = described(name))
          return table_of(*description).make(description->defaults.get());
        return known_spec(name).make_default();
      },
      py::arg("name"), "Returns a dataclass with the defaults of its C++ struct.");
  m.def(
      "spec_round_trip",
      [](const py::object& value) {
        const py::handle type = py::type::handle_of(value);
        const auto name = py::str(type.attr("__module__")).cast<std::string>() + "." +
                          py::str(type.attr("__qualname__")).cast<std::string>();
        const Description* description = described(name);
        if (description == nullptr) return known_spec(name).round_trip(value);
        const std::shared_ptr<void> spec = description->make();
        if (!table_of(*description).load(value, spec.get())) return py::object();
        return table_of(*description).make(spec.get());
      },
      py::arg("value"), "Converts a dataclass to its C++ struct and back.");
  m.def(
      "enum_words",
      [] {
        std::map<std::string, std::vector<std::string>> words;
        for (const auto table : known_enums()) words[table().full_name()] = table().words();
        for (const auto& [name, of] : described_enums()) words["burnish." + name] = of->list();
        return words;
      },
      "Returns the names of the members of all enumerations, in the order of their values.");
  bind_described(m);
}

std::string wanted_array(Eigen::Index rows, Eigen::Index columns) {
  const auto count = [](Eigen::Index n) { return n < 0 ? std::string("n") : std::to_string(n); };
  if (columns == 1) return rows < 0 ? "a vector of numbers" : count(rows) + " numbers";
  return "an array of " + count(rows) + " x " + count(columns) + " numbers";
}

}  // namespace burnish::python
