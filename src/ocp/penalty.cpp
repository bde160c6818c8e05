#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/ocp/problem_spec.hpp"

namespace burnish {

Penalty Penalty::barrier(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  return {Kind::Barrier, lower, upper};
}
Penalty Penalty::at_least(double lower) {
  return {Kind::Barrier, Eigen::VectorXd::Constant(1, lower), {}};
}
Penalty Penalty::smooth_absolute(double width) { return {Kind::SmoothAbsolute, {}, {}, width}; }
Penalty Penalty::log_barrier(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                             double width) {
  return {Kind::LogBarrier, lower, upper, width};
}

namespace {
const std::vector<std::string>& names() {
  static const std::vector<std::string> all{"quadratic", "barrier", "smooth_absolute",
                                            "log_barrier"};
  return all;
}
}  // namespace

std::string name_of(Penalty::Kind kind) { return names()[to_size(kind)]; }

Penalty::Kind parse_penalty(const std::string& name) {
  for (std::size_t i = 0; i < names().size(); ++i)
    if (names()[i] == name) return static_cast<Penalty::Kind>(i);
  throw Error("unknown penalty " + in_quotes(name) +
              "; wanted quadratic, barrier, smooth_absolute or log_barrier" +
              did_you_mean(name, names()));
}

}  // namespace burnish
