#include "spec.hpp"

#include <algorithm>
#include <cctype>

namespace burnish::python {

namespace {

std::string small(std::string word) {
  for (char& letter : word)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

/// What came, short enough for a sentence.
std::string shown(py::handle value) {
  std::string text = py::repr(value);
  constexpr std::size_t longest = 60;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

}  // namespace

py::handle PythonClass::get() const {
  if (!class_) class_ = py::object(py::module_::import(module_).attr(name_)).release();
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
    throw Error(std::string(class_.name()) + ": there is no '" + word + "'" +
                did_you_mean(small(word), words_));
  value = static_cast<int>(found - words_.begin());
  return true;
}

py::object EnumTable::make(int value) const {
  return py::reinterpret_borrow<py::object>(class_.get())(value);
}

bool SpecTable::load(py::handle from, void* spec) const {
  if (!py::isinstance(from, class_.get())) return false;
  for (const Field& field : fields_) {
    const py::object value = from.attr(field.name);
    if (!field.set(spec, value))
      throw Error(std::string(class_.name()) + "." + field.name + ": got " + shown(value) +
                  ", wanted " + field.wanted());
  }
  return true;
}

py::object SpecTable::make(const void* spec) const {
  py::dict values;
  for (const Field& field : fields_) values[field.name] = field.get(spec);
  return py::reinterpret_borrow<py::object>(class_.get())(**values);
}

std::string wanted_array(Eigen::Index rows, Eigen::Index columns) {
  const auto count = [](Eigen::Index n) { return n < 0 ? std::string("n") : std::to_string(n); };
  if (columns == 1) return rows < 0 ? "a vector of numbers" : count(rows) + " numbers";
  return "an array of " + count(rows) + " x " + count(columns) + " numbers";
}

}  // namespace burnish::python
