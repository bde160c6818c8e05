#include "robots/yaml_text.hpp"

#include "base/sentence.hpp"
#include "base/text_file.hpp"

namespace burnish {
namespace {

constexpr int megabytes = 4;  // of lists without end 1 GB in memory
/// That a reader may come by, those behind an alias each time.
constexpr std::size_t max_values = 1'000'000;
/// Readers follow nestings by functions that call themselves, and aliases may close a circle.
constexpr int max_nesting = 100;

/// Counts values as a reader comes by them.
class Walk {
 public:
  explicit Walk(const std::string& name) : name_(name) {}

  void visit(const YAML::Node& node, int depth) {
    if (++values_ > max_values) {
      refuse(name_, "it has more than " + std::to_string(max_values) +
                        " values, those of an alias counted wherever it stands; at most that many "
                        "are read");
    }
    if (depth > max_nesting) {
      const YAML::Mark mark = node.Mark();
      refuse(name_, (mark.is_null() ? "" : "line " + std::to_string(mark.line + 1) + ": ") +
                        "values are nested more than " + std::to_string(max_nesting) +
                        " deep, or an alias stands for what holds it");
    }
    if (node.IsSequence()) {
      for (const auto& item : node) visit(item, depth + 1);
    } else if (node.IsMap()) {
      for (const auto& pair : node) {
        visit(pair.first, depth + 1);
        visit(pair.second, depth + 1);
      }
    }
  }

 private:
  const std::string& name_;
  std::size_t values_ = 0;
};

}  // namespace

YAML::Node parse_yaml(const std::string& text, const std::string& name) {
  check_size(text, name, megabytes);
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    refuse(name, "line " + std::to_string(error.mark.line + 1) + ": this is no YAML: " + error.msg);
  }
  Walk(name).visit(root, 0);
  return root;
}

}  // namespace burnish
