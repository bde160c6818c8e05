// Evaluation of a request of `burnish eval`, with the answer as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "request.hpp"

namespace burnish::app {

struct Answer {
  nlohmann::ordered_json json;
  bool good = true;  ///< True if every evaluation returned the status ok.
};

Answer evaluate(const EvalRequest& request);

}  // namespace burnish::app
