#include "contact_text.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>

#include "burnish/base/error.hpp"

namespace burnish::app {
namespace {

const std::vector<std::string> keys{"name",       "tool",  "base", "reference", "normal",
                                    "directions", "error", "kp",   "kd",        "acceleration"};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, at);) pieces.push_back(piece);
  return pieces;
}

std::map<std::string, std::string> read_pairs(const std::string& text) {
  std::map<std::string, std::string> pairs;
  std::string last;
  for (const std::string& piece : split(text, ',')) {
    const std::size_t equals = piece.find('=');
    if (equals == std::string::npos) {
      if (last.empty()) {
        throw Error("'" + piece + "' is no key=value; wanted such as tool=flange,directions=z");
      }
      pairs[last] += "," + piece;
      continue;
    }
    last = piece.substr(0, equals);
    if (std::find(keys.begin(), keys.end(), last) == keys.end()) {
      const std::string hint = did_you_mean(last, keys);
      throw Error(
          fmt::format("unknown key '{}'{}", last,
                      hint.empty() ? fmt::format("; known are {}", fmt::join(keys, ", ")) : hint));
    }
    if (!pairs.emplace(last, piece.substr(equals + 1)).second) {
      throw Error("key '" + last + "' is given twice");
    }
  }
  return pairs;
}

double read_number(const std::string& key, const std::string& text) {
  std::size_t used = 0;
  double value = 0.0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != text.size()) throw Error(key + ": '" + text + "' is no number");
  return value;
}

Eigen::VectorXd read_numbers(const std::string& key, const std::string& text) {
  const std::vector<std::string> words = split(text, ',');
  Eigen::VectorXd values(static_cast<Eigen::Index>(words.size()));
  for (std::size_t i = 0; i < words.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = read_number(key, words[i]);
  }
  return values;
}

Vector6 read_gains(const std::string& key, const std::string& text) {
  const Eigen::VectorXd values = read_numbers(key, text);
  if (values.size() == 1) return Vector6::Constant(values[0]);
  if (values.size() != 6) {
    throw Error(fmt::format("{}: it has {} numbers; wanted 1 or 6", key, values.size()));
  }
  return values;
}

Reference read_reference(const std::map<std::string, std::string>& pairs) {
  const auto name = pairs.find("reference"), normal = pairs.find("normal");
  if (normal == pairs.end()) {
    return name == pairs.end() ? Reference::centered() : Reference::parse(name->second);
  }
  if (name != pairs.end() && name->second != "surface") {
    throw Error("normal goes with reference=surface, not with reference=" + name->second);
  }
  const Eigen::VectorXd values = read_numbers("normal", normal->second);
  if (values.size() != 3) {
    throw Error(fmt::format("normal: it has {} numbers; wanted 3", values.size()));
  }
  return Reference::surface_with_normal(values);
}

}  // namespace

ContactSpec parse_contact(const std::string& text) {
  try {
    const std::map<std::string, std::string> pairs = read_pairs(text);
    if (!pairs.contains("tool")) throw Error("key 'tool' is missing");
    ContactSpec spec;
    spec.reference = read_reference(pairs);
    for (const auto& [key, value] : pairs) {
      if (key == "name") spec.name = value;
      if (key == "tool") spec.tool = value;
      if (key == "base") spec.base = value;
      if (key == "directions") spec.directions = Directions::parse(value);
      if (key == "acceleration") spec.acceleration = parse_acceleration(value);
      if (key == "error") spec.error = parse_pose_error(value);
      if (key == "kp") spec.kp = read_gains(key, value);
      if (key == "kd") spec.kd = read_gains(key, value);
    }
    return spec;
  } catch (const Error& error) {
    throw Error("--contact " + text + ": " + error.what());
  }
}

}  // namespace burnish::app
