#include "files/yaml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "robots/yaml_text.hpp"

namespace burnish::files {

YamlReader YamlReader::load(const std::filesystem::path& file) {
  return parse(read_text(file, "YAML file"), file.string());
}

YamlReader YamlReader::parse(const std::string& text, const std::string& name) {
  return {name, "", parse_yaml(text, name)};
}

YamlReader YamlReader::child(const std::string& key, const YAML::Node& value) const {
  return {file_, path_.empty() ? key : path_ + "." + key, value};
}

void YamlReader::refuse(const std::string& what) const {
  if (what.rfind(file_ + ": ", 0) == 0) burnish::refuse(file_, what.substr(file_.size() + 2));
  const YAML::Mark mark = node_.Mark();
  const std::string line = mark.is_null() ? "" : "line " + std::to_string(mark.line + 1) + ": ";
  burnish::refuse(file_, line + (path_.empty() ? "" : path_ + ": ") + what);
}

bool YamlReader::is_text() const { return node_.IsScalar() && !is_number(); }
bool YamlReader::is_number() const {
  return node_.IsScalar() && parse_number(node_.Scalar()).has_value();
}

void YamlReader::allow_only(const std::vector<std::string>& keys) const {
  for (const auto& [key, value] : items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::string nearest = did_you_mean(key, keys);
    refuse("key " + in_quotes(key) + " is unknown" +
           (nearest.empty() ? "; known are " + either(keys) : nearest));
  }
}

bool YamlReader::has(const std::string& key) const { return find(key).has_value(); }

std::optional<YamlReader> YamlReader::find(const std::string& key) const {
  if (!node_.IsMap()) return std::nullopt;
  for (const auto& pair : node_)
    if (pair.first.IsScalar() && pair.first.Scalar() == key) return child(key, pair.second);
  return std::nullopt;
}

YamlReader YamlReader::operator[](const std::string& key) const {
  if (!node_.IsMap()) refuse("wanted keys with values, " + in_quotes(key) + " among them");
  if (auto found = find(key)) return *found;
  refuse("key " + in_quotes(key) + " is missing");
}

std::vector<std::pair<std::string, YamlReader>> YamlReader::items() const {
  if (!node_.IsMap()) refuse("wanted keys with values");
  std::vector<std::pair<std::string, YamlReader>> result;
  std::set<std::string> seen;
  for (const auto& pair : node_) {
    if (!pair.first.IsScalar()) refuse("its keys must be names");
    const std::string key = pair.first.Scalar();
    if (!seen.insert(key).second)
      refuse("key " + in_quotes(key) + " is stated twice; state it once");
    result.emplace_back(key, child(key, pair.second));
  }
  return result;
}

std::vector<YamlReader> YamlReader::entries() const {
  if (!node_.IsSequence()) refuse("wanted a list");
  std::vector<YamlReader> result;
  for (const auto& item : node_)
    result.push_back({file_, path_ + "[" + std::to_string(result.size()) + "]", item});
  return result;
}

YamlReader YamlReader::changed_by(const YamlReader& changes) const {
  YAML::Node merged(YAML::NodeType::Map);
  for (const auto& [key, value] : items())
    if (!changes.has(key)) merged[key] = value.node_;
  for (const auto& [key, value] : changes.items()) merged[key] = value.node_;
  return {file_, changes.path_, merged};
}

double YamlReader::number() const {
  if (!node_.IsScalar()) refuse("wanted a number");
  const std::optional<double> value = parse_number(node_.Scalar());
  if (!value) refuse(in_quotes(node_.Scalar()) + " is no number");
  if (!std::isfinite(*value)) refuse(burnish::number(*value) + " is not finite");
  return *value;
}

double YamlReader::positive() const {
  const double value = number();
  if (!(value > 0.0)) refuse("it is " + burnish::number(value) + "; wanted more than 0");
  return value;
}

double YamlReader::not_negative() const {
  const double value = number();
  if (value < 0.0) refuse("it is " + burnish::number(value) + "; wanted at least 0");
  return value;
}

int YamlReader::count(int least) const {
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > 1e9)
    refuse("it is " + burnish::number(value) + "; wanted a whole number");
  if (value < least)
    refuse("it is " + burnish::number(value) + "; wanted at least " + std::to_string(least));
  return static_cast<int>(value);
}

bool YamlReader::yes_or_no() const {
  if (!is("true") && !is("false")) refuse("wanted true or false");
  return is("true");
}

std::string YamlReader::text() const {
  if (!node_.IsScalar() || node_.Scalar().empty()) refuse("wanted a text");
  return node_.Scalar();
}

std::vector<std::string> YamlReader::texts() const {
  if (node_.IsScalar()) return {text()};
  std::vector<std::string> result;
  for (const YamlReader& entry : entries()) result.push_back(entry.text());
  return result;
}

Eigen::VectorXd YamlReader::numbers() const {
  const std::vector<YamlReader> list = entries();
  if (list.empty()) refuse("the list is empty; wanted numbers");
  Eigen::VectorXd result(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    result[static_cast<Eigen::Index>(i)] = list[i].number();
  return result;
}

Eigen::VectorXd YamlReader::numbers(Eigen::Index size) const {
  if (!is_list()) refuse("wanted a list of " + std::to_string(size) + " numbers");
  Eigen::VectorXd result = numbers();
  if (result.size() != size)
    refuse("it has " + std::to_string(result.size()) + " numbers; wanted " + std::to_string(size));
  return result;
}

std::string YamlReader::word(const std::vector<std::string>& known) const {
  const std::string value = text();
  if (std::find(known.begin(), known.end(), value) != known.end()) return value;
  const std::string nearest = did_you_mean(value, known);
  refuse(in_quotes(value) + " is unknown" +
         (nearest.empty() ? "; wanted " + either(known) : nearest));
}

std::string either(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

}  // namespace burnish::files
