// Evaluates a request and writes the answer as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "request.hpp"

namespace burnish::app {

struct Answer {
  nlohmann::ordered_json json;
  bool good = true;  ///< every evaluation had status ok
};

Answer evaluate(const EvalRequest& request);

}  // namespace burnish::app
