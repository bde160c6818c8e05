// Notes about ignored content: one sentence per kind, with the number of occurrences.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace burnish::mjcf {

class OmissionNotes {
 public:
  /// Adds an occurrence. `what` describes the kind of content, `example` names one element.
  void note(const std::string& what, const std::string& example) {
    const auto same = std::find_if(kinds_.begin(), kinds_.end(),
                                   [&](const Kind& kind) { return kind.what == what; });
    if (same != kinds_.end())
      ++same->count;
    else
      kinds_.push_back({what, example, 1});
  }

  std::vector<std::string> sentences() const {
    std::vector<std::string> all;
    for (const Kind& kind : kinds_) {
      const std::string several =
          kind.count > 1 ? std::to_string(kind.count) + " of them, such as " : "";
      all.push_back(kind.what + " (" + several + kind.example + ")");
    }
    return all;
  }

 private:
  struct Kind {
    std::string what, example;
    int count;
  };
  std::vector<Kind> kinds_;
};

}  // namespace burnish::mjcf
