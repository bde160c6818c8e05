// Keys that hold one value, and how values are written.
#include <charconv>
#include <cmath>
#include <limits>

#include "base/yaml_word.hpp"
#include "polishing/task_keys.hpp"

namespace burnish::polishing {

std::string yaml(double value) {
  char text[32];
  const double size = std::abs(value);
  const bool plain = value == 0.0 || (size >= 1e-4 && size < 1e9);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  return {text, std::to_chars(text, text + sizeof text, value, format).ptr};
}

std::string yaml(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + yaml(values[i]);
  return text + "]";
}

std::string yaml(const std::string& text) { return yaml_word(text); }

TaskKey number_key(const char* name, const char* meaning, Range range,
                   const std::function<double&(Task&)>& entry) {
  const bool may_be_never = range == Range::PositiveOrNever;
  return {name, meaning,
          [=](Task& task, const files::YamlReader& reader) {
            if (may_be_never && reader.is("never"))
              entry(task) = std::numeric_limits<double>::infinity();
            else if (range == Range::Any)
              entry(task) = reader.number();
            else
              entry(task) = range == Range::Positive || may_be_never ? reader.positive()
                                                                     : reader.not_negative();
            if (range == Range::Share && entry(task) > 1.0)
              reader.refuse("it is " + yaml(entry(task)) + "; wanted a share between 0 and 1");
          },
          [=](const Task& task) -> std::optional<std::string> {
            Task copy = task;
            return std::isinf(entry(copy)) ? "never" : yaml(entry(copy));
          }};
}

TaskKey count_key(const char* name, const char* meaning, int least,
                  const std::function<int&(Task&)>& entry) {
  return {name, meaning,
          [=](Task& task, const files::YamlReader& reader) { entry(task) = reader.count(least); },
          [=](const Task& task) -> std::optional<std::string> {
            Task copy = task;
            return std::to_string(entry(copy));
          }};
}

TaskKey flag_key(const char* name, const char* meaning, const std::function<bool&(Task&)>& entry) {
  return {name, meaning,
          [=](Task& task, const files::YamlReader& reader) { entry(task) = reader.yes_or_no(); },
          [=](const Task& task) -> std::optional<std::string> {
            Task copy = task;
            return entry(copy) ? "true" : "false";
          }};
}

TaskKey text_key(const char* name, const char* meaning,
                 const std::function<std::string&(Task&)>& entry) {
  return {name, meaning,
          [=](Task& task, const files::YamlReader& reader) { entry(task) = reader.text(); },
          [=](const Task& task) -> std::optional<std::string> {
            Task copy = task;
            if (entry(copy).empty()) return std::nullopt;
            return yaml(entry(copy));
          }};
}

}  // namespace burnish::polishing
