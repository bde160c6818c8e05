#include "json_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/text_file.hpp"

namespace burnish::app {
namespace {

std::string kind_of(const nlohmann::json& value) {
  if (value.is_null()) return "null";
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number()) return "the number " + value.dump();
  if (value.is_string()) return "the text " + value.dump();
  return value.is_array() ? "a list" : "an object";
}

std::string member(const std::string& place, const std::string& key) {
  return place.empty() ? key : place + "." + key;
}

/// "parse error at line 1, column 2: ..." without the library's own number in front.
std::string parse_sentence(std::string text) {
  const std::size_t bracket = text.find("] ");
  if (bracket != std::string::npos) text.erase(0, bracket + 2);
  return text;
}

Eigen::Matrix3d rotation_of(const JsonReader& reader) {
  if (reader.has("matrix")) {
    const Eigen::Matrix3d R = reader["matrix"].matrix3();
    if ((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() > 1e-6 || R.determinant() < 0.0) {
      reader["matrix"].refuse("it is not a rotation matrix");
    }
    return R;
  }
  if (reader.has("quaternion")) {
    const Eigen::Vector4d q = reader["quaternion"].numbers(4);
    if (std::abs(q.norm() - 1.0) > 1e-3) {
      reader["quaternion"].refuse(
          fmt::format("it has length {:.6g}; wanted 1 (in the order x, y, z, w)", q.norm()));
    }
    return Eigen::Quaterniond(q).normalized().toRotationMatrix();
  }
  if (!reader.has("rpy")) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d a = reader["rpy"].numbers(3);
  return (Eigen::AngleAxisd(a.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(a.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(a.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

/// Refuses keys that an object has twice, of which parsing keeps one. Not a callback of the parser:
/// with one, the time it takes grows with the square of a list's length.
class TwinKeys : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TwinKeys(const std::string& source) : source_(source) {}

  bool start_object(std::size_t /*size*/) override {
    open_.emplace_back();
    return true;
  }
  bool end_object() override {
    open_.pop_back();
    return true;
  }
  bool key(std::string& key) override {
    if (open_.back().insert(key).second) return true;
    throw Error(fmt::format("{}: key '{}' stands twice in one object", source_, key));
  }
  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(std::int64_t /*value*/) override { return true; }
  bool number_unsigned(std::uint64_t /*value*/) override { return true; }
  bool number_float(double /*value*/, const std::string& /*text*/) override { return true; }
  bool string(std::string& /*value*/) override { return true; }
  bool binary(nlohmann::json::binary_t& /*value*/) override { return true; }
  bool start_array(std::size_t /*size*/) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*error*/) override {
    return false;
  }

 private:
  const std::string& source_;
  std::vector<std::set<std::string>> open_;
};

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& source) {
  constexpr int megabytes = 32;  // of the shortest objects 1 GB in memory
  check_size(text, source, megabytes);
  try {
    nlohmann::json result = nlohmann::json::parse(text);
    TwinKeys twins(source);
    nlohmann::json::sax_parse(text, &twins);
    return result;
  } catch (const nlohmann::json::exception& error) {
    throw Error(source + ": " + parse_sentence(error.what()));
  }
}

void JsonReader::refuse(const std::string& what) const {
  throw Error(place_.empty() ? what : place_ + ": " + what);
}

void JsonReader::allow_only(const std::vector<std::string>& keys) const {
  if (!is_object()) refuse("it is " + kind_of(value_) + "; wanted an object");
  for (const auto& item : value_.items()) {
    if (std::find(keys.begin(), keys.end(), item.key()) != keys.end()) continue;
    const std::string hint = did_you_mean(item.key(), keys);
    refuse(fmt::format("unknown key '{}'{}", item.key(),
                       hint.empty() ? fmt::format("; known are {}", fmt::join(keys, ", ")) : hint));
  }
}

JsonReader JsonReader::operator[](const std::string& key) const {
  if (!has(key)) refuse("key '" + key + "' is missing");
  return {value_.at(key), member(place_, key)};
}

std::vector<JsonReader> JsonReader::entries() const {
  if (!is_list()) refuse("it is " + kind_of(value_) + "; wanted a list");
  std::vector<JsonReader> result;
  for (std::size_t i = 0; i < value_.size(); ++i) {
    result.emplace_back(value_[i], fmt::format("{}[{}]", place_, i));
  }
  return result;
}

std::string JsonReader::text() const {
  if (!is_text()) refuse("it is " + kind_of(value_) + "; wanted a text");
  return value_.get<std::string>();
}

double JsonReader::number() const {
  if (!is_number()) refuse("it is " + kind_of(value_) + "; wanted a number");
  return value_.get<double>();
}

int JsonReader::count() const {
  if (!value_.is_number_integer() || value_.get<double>() < 0.0 || value_.get<double>() > 1e9) {
    refuse("it is " + kind_of(value_) + "; wanted a whole number that is not negative");
  }
  return value_.get<int>();
}

bool JsonReader::yes_or_no() const {
  if (!value_.is_boolean()) refuse("it is " + kind_of(value_) + "; wanted true or false");
  return value_.get<bool>();
}

std::vector<std::string> JsonReader::texts() const {
  if (is_text()) return {text()};
  std::vector<std::string> result;
  for (const JsonReader& entry : entries()) result.push_back(entry.text());
  return result;
}

Eigen::VectorXd JsonReader::numbers() const {
  const std::vector<JsonReader> list = entries();
  Eigen::VectorXd result(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) {
    result[static_cast<Eigen::Index>(i)] = list[i].number();
  }
  return result;
}

Eigen::VectorXd JsonReader::numbers(int size) const {
  Eigen::VectorXd result = numbers();
  if (result.size() != size) {
    refuse(fmt::format("it has {} numbers; wanted {}", result.size(), size));
  }
  return result;
}

Eigen::Matrix3d JsonReader::matrix3() const {
  const std::vector<JsonReader> rows = entries();
  if (rows.size() != 3) refuse(fmt::format("it has {} rows; wanted 3", rows.size()));
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) result.row(i) = rows[static_cast<std::size_t>(i)].numbers(3);
  return result;
}

Eigen::Isometry3d JsonReader::placement(const std::vector<std::string>& also) const {
  std::vector<std::string> keys{"xyz", "quaternion", "rpy", "matrix"};
  keys.insert(keys.end(), also.begin(), also.end());
  allow_only(keys);
  if (int(has("quaternion")) + int(has("rpy")) + int(has("matrix")) > 1) {
    refuse("it has more than one of quaternion, rpy and matrix; wanted one");
  }
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (has("xyz")) result.translation() = (*this)["xyz"].numbers(3);
  result.linear() = rotation_of(*this);
  return result;
}

}  // namespace burnish::app
