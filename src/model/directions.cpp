#include "burnish/model/directions.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace burnish {
namespace {

struct DirectionsName {
  std::string_view name;
  Directions value;
};
constexpr std::array<DirectionsName, 12> words{{{"x", {1}},
                                                {"y", {2}},
                                                {"z", {4}},
                                                {"rx", {8}},
                                                {"ry", {16}},
                                                {"rz", {32}},
                                                {"all", Directions::all()},
                                                {"linear", Directions::linear()},
                                                {"angular", Directions::angular()},
                                                {"pad_x", Directions::pad_x()},
                                                {"pad_y", Directions::pad_y()},
                                                {"pad_z", Directions::pad_z()}}};

Directions parse_word(std::string_view word) {
  std::vector<std::string> existing;
  for (const DirectionsName& named : words) {
    if (named.name == word) return named.value;
    existing.emplace_back(named.name);
  }
  throw Error("directions: unknown word '" + std::string(word) +
              "'; wanted x, y, z, rx, ry, rz, all, linear, angular, pad_x, pad_y or pad_z" +
              did_you_mean(word, existing));
}

}  // namespace

Directions Directions::parse(std::string_view text) {
  Directions result;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    std::string_view word = text.substr(0, comma);
    while (!word.empty() && word.front() == ' ') word.remove_prefix(1);
    while (!word.empty() && word.back() == ' ') word.remove_suffix(1);
    result = result | parse_word(word);
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  if (result.bits == 0) throw Error("directions: the set is empty; wanted at least one direction");
  return result;
}

std::string Directions::text() const {
  std::string result;
  for (int d = 0; d < 6; ++d)
    if (has(d)) result += (result.empty() ? "" : ",") + std::string(direction_names[d]);
  return result;
}

}  // namespace burnish
