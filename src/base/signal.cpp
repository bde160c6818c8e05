#include "burnish/base/signal.hpp"

#include "burnish/base/error.hpp"

namespace burnish {

Signal Signal::over_time(int size, Function function) {
  if (size < 1)
    throw Error("a signal over time has " + std::to_string(size) + " entries; wanted at least 1");
  if (!function) throw Error("a signal over time has no function; wanted one");
  Signal result;
  result.size_ = size;
  result.function_ = std::move(function);
  return result;
}

void Signal::hold(const ConstVectorRef& value) { constant_ = value; }

void Signal::at(double time, Eigen::Ref<Eigen::VectorXd> out) const {
  if (function_) {
    function_(time, out);
  } else {
    out = constant_;
  }
}

}  // namespace burnish
