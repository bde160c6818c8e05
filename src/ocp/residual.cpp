#include "burnish/ocp/residual.hpp"

#include <cctype>

#include "ocp/descriptions.gen.hpp"

namespace burnish {
namespace {
struct NameOf {
  std::string operator()(const Described auto& residual) const {
    return in_words(description_of(&residual).name);
  }
  std::string operator()(const residual::Custom& r) const {
    return r.name.empty() ? "custom" : r.name;
  }
  static std::string in_words(const std::string& type) {
    std::string words;
    for (const char c : type) {
      const auto letter = static_cast<unsigned char>(c);
      if (std::isupper(letter) != 0 && !words.empty()) words += ' ';
      words += static_cast<char>(std::tolower(letter));
    }
    return words;
  }
};
}  // namespace

std::string name_of(const Residual& residual) { return std::visit(NameOf{}, residual); }

}  // namespace burnish
