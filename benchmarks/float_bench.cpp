// Comparison of the kernels on packs of floats and of doubles: time per state, and errors of the
// blocks of derivatives. docs/performance.md has the conclusions.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>

#include "cases.hpp"
#include "derivatives/constrained_derivatives.tpp"
#include "float_pack.hpp"

namespace burnish {
extern template class ConstrainedDynamics<NativePack>;
extern template class ConstrainedDerivatives<NativePack>;
template class ConstrainedDynamics<bench::NativeFloatPack>;
template class ConstrainedDerivatives<bench::NativeFloatPack>;
}  // namespace burnish

namespace burnish::bench {
namespace {

constexpr int ring = 256;
constexpr int rounds = 200;
static_assert(ring % Lanes<NativeFloatPack>::count == 0);

/// Returns the CPU time of this thread [s].
double core_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Kernels with packed states.
template <class S>
class PackedStates {
 public:
  static constexpr int lanes = Lanes<S>::count;

  PackedStates(const Case& what, const States& states)
      : dynamics(model_of(what.robot), ContactSet(model_of(what.robot), what.specs("centered")),
                 {}),
        derivatives(dynamics) {
    for (int first = 0; first < ring; first += lanes)
      packs_.push_back({pack(states.q, first), pack(states.v, first), pack(states.tau, first)});
  }

  void evaluate(int i, bool with_derivatives) {
    const State& x = packs_[static_cast<std::size_t>(i)];
    dynamics.set_state(x.q.data(), x.v.data());
    dynamics.forward(x.tau.data());
    if (with_derivatives) derivatives.forward(dynamics);
  }

  /// Evaluates all states once and returns the time per state [us].
  double time(bool with_derivatives) {
    const double start = core_time();
    for (int i = 0; i < ring / lanes; ++i) evaluate(i, with_derivatives);
    return 1e6 * (core_time() - start) / ring;
  }

  ConstrainedDynamics<S> dynamics;
  ConstrainedDerivatives<S> derivatives;

 private:
  struct State {
    std::vector<S> q, v, tau;
  };
  static std::vector<S> pack(const Eigen::MatrixXd& from, int first) {
    std::vector<S> to(static_cast<std::size_t>(from.rows()));
    for (Eigen::Index i = 0; i < from.rows(); ++i)
      for (int l = 0; l < lanes; ++l)
        Lanes<S>::set(to[static_cast<std::size_t>(i)], l, from(i, first + l));
    return to;
  }

  std::vector<State> packs_;
};

using Doubles = PackedStates<NativePack>;
using Floats = PackedStates<NativeFloatPack>;

void print_times(const Case& what, Doubles& doubles, Floats& floats) {
  std::printf("| %s, %s |", what.label.c_str(), what.contact.c_str());
  for (const bool with_derivatives : {false, true}) {
    double wide = std::numeric_limits<double>::infinity(), narrow = wide;
    for (int round = 0; round < rounds; ++round) {
      wide = std::min(wide, doubles.time(with_derivatives));
      narrow = std::min(narrow, floats.time(with_derivatives));
    }
    std::printf(" %.3f | %.3f | %.2f |", wide, narrow, wide / narrow);
  }
  std::printf("\n");
}

/// Returns the error of a block of derivatives of one state: largest difference over largest entry;
/// 0 for a block of zeros, such as da/dtau if contacts permit no motion.
double block_error(const std::vector<NativePack>& exact, int lane,
                   const std::vector<NativeFloatPack>& rounded, int rounded_lane, int first,
                   int end) {
  double difference = 0.0, largest = 0.0;
  for (int i = first; i < end; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double entry = Lanes<NativePack>::get(exact[k], lane);
    const double other = Lanes<NativeFloatPack>::get(rounded[k], rounded_lane);
    difference = std::max(difference, std::abs(other - entry));
    largest = std::max(largest, std::abs(entry));
  }
  return largest > 1e-9 ? difference / largest : 0.0;
}

/// Prints median and maximum of the errors over the states, for each block.
void print_errors(const Case& what, Doubles& doubles, Floats& floats) {
  const int nv = doubles.dynamics.nv(), rows = nv + doubles.dynamics.rows();
  std::vector<double> errors[6];
  for (int state = 0; state < ring; ++state) {
    doubles.evaluate(state / Doubles::lanes, true);
    floats.evaluate(state / Floats::lanes, true);
    const auto& d = doubles.derivatives;
    const auto& f = floats.derivatives;
    auto* to = errors;
    const auto add = [&](const auto& exact, const auto& rounded) {
      const int lane = state % Doubles::lanes, rounded_lane = state % Floats::lanes;
      (to++)->push_back(block_error(exact, lane, rounded, rounded_lane, 0, nv * nv));
      (to++)->push_back(block_error(exact, lane, rounded, rounded_lane, nv * nv, rows * nv));
    };
    add(d.d_dq, f.d_dq);
    add(d.d_dv, f.d_dv);
    add(d.d_dtau, f.d_dtau);
  }
  std::printf("| %s, %s |", what.label.c_str(), what.contact.c_str());
  for (auto& block : errors) {
    std::sort(block.begin(), block.end());
    if (block.back() == 0.0) {
      std::printf(" zero |");
    } else {
      std::printf(" %.0e, %.0e |", block[block.size() / 2], block.back());
    }
  }
  std::printf("\n");
}

template <class Print>
void for_each_case(const Print& print) {
  for (const Case& what : cases()) {
    const States states = states_near_reference(what.robot, ring);
    Doubles doubles(what, states);
    Floats floats(what, states);
    print(what, doubles, floats);
  }
}

void run() {
  std::printf(
      "us per state, %d doubles or %d floats at once\n\n"
      "| robot, contact | dynamics: double | float | ratio "
      "| and derivatives: double | float | ratio |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
      Doubles::lanes, Floats::lanes);
  for_each_case(print_times);
  std::printf(
      "\nerror of floats by the largest entry of the block: median, maximum of %d states\n\n"
      "| robot, contact | da/dq | dlambda/dq | da/dv | dlambda/dv | da/dtau | dlambda/dtau |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n",
      ring);
  for_each_case(print_errors);
}

}  // namespace
}  // namespace burnish::bench

int main() {
  burnish::bench::run();
  return 0;
}
