#include "burnish/base/signal.hpp"

#include <limits>

#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

void check_function(int size, bool has_function) {
  if (size < 1)
    throw Error("a signal over time has " + std::to_string(size) + " entries; wanted at least 1");
  if (!has_function) throw Error("a signal over time has no function; wanted a function of time");
}

}  // namespace

Eigen::Map<const Eigen::VectorXd> InputValues::operator[](int input) const {
  if (input < 0 || to_size(input) + 1 >= first_.size()) return {nullptr, 0};
  const int first = first_[to_size(input)];
  return {values_ + first, first_[to_size(input) + 1] - first};
}

double InputValues::scalar(int input) const {
  const auto value = (*this)[input];
  return value.size() == 0 ? std::numeric_limits<double>::quiet_NaN() : value[0];
}

Signal Signal::over_time(int size, Function function) {
  check_function(size, function != nullptr);
  Signal result;
  result.size_ = size;
  result.function_ = std::move(function);
  return result;
}

Signal Signal::of_inputs(int size, FunctionOfInputs function) {
  check_function(size, function != nullptr);
  Signal result;
  result.size_ = size;
  result.of_inputs_ = std::move(function);
  return result;
}

void Signal::hold(const ConstVectorRef& value) { constant_ = value; }

void Signal::at(double time, Eigen::Ref<Eigen::VectorXd> out, const InputValues& inputs) const {
  if (function_) {
    function_(time, out);
  } else if (of_inputs_) {
    of_inputs_(time, inputs, out);
  } else {
    out = constant_;
  }
}

}  // namespace burnish
