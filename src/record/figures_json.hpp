// Key figures of a run as JSON, by the names in report/figures.hpp.
#pragma once

#include "record/json_text.hpp"
#include "report/figures.hpp"

namespace burnish {

/// Returns a figure as JSON; null if it is missing or not finite.
template <class Value>
Json figure_json(const Value& value) {
  if constexpr (std::integral<Value> || std::same_as<Value, std::string>)
    return value;
  else
    return number_json(value);
}

Json metrics_json(const Metrics& metrics);

}  // namespace burnish
