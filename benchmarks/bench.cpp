// Computing time per state of contact dynamics and its derivatives; README.md describes names and
// use.
#include <benchmark/benchmark.h>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "cases.hpp"
#include "derivatives/constrained_derivatives.hpp"
#include "math/pack.hpp"

namespace burnish {
extern template class ConstrainedDynamics<NativePack>;
extern template class ConstrainedDerivatives<NativePack>;
}  // namespace burnish

namespace burnish::bench {
namespace {

constexpr int ring = 64;
static_assert(ring % native_lanes == 0);

enum class Work { InverseDerivatives, Forward, ForwardDerivatives };

/// Evaluation of one state at a time by the public API.
class Scalar {
 public:
  static constexpr int states_per_step = 1;
  static constexpr int lanes = 1;
  Scalar(const Model& model, const std::vector<ContactSpec>& specs, const States& states)
      : states_(states),
        dynamics_(model, specs),
        lambda_(Eigen::VectorXd::Ones(dynamics_.rows())) {}

  double step(Work work, int i) {
    if (work == Work::InverseDerivatives) {
      dynamics_.inverse(states_.q.col(i), states_.v.col(i), states_.tau.col(i), lambda_);
      dynamics_.inverse_derivatives();
      return dynamics_.dtau_dq()(0, 0);
    }
    dynamics_.forward(states_.q.col(i), states_.v.col(i), states_.tau.col(i));
    if (work == Work::Forward) return dynamics_.a()[0];
    dynamics_.forward_derivatives();
    return dynamics_.da_dq()(0, 0);
  }

 private:
  const States& states_;
  ContactDynamics dynamics_;
  Eigen::VectorXd lambda_;
};

/// Evaluation by the kernels on packed states.
class PackedStates {
 public:
  static constexpr int states_per_step = native_lanes;
  static constexpr int lanes = native_lanes;
  PackedStates(const Model& model, const std::vector<ContactSpec>& specs, const States& states)
      : dynamics_(model, ContactSet(model, specs), {}),
        derivatives_(dynamics_),
        lambda_(static_cast<std::size_t>(dynamics_.rows()), NativePack(1.0)) {
    for (int first = 0; first < ring; first += native_lanes)
      packs_.push_back({pack(states.q, first), pack(states.v, first), pack(states.tau, first)});
  }

  double step(Work work, int i) {
    const State& x = packs_[static_cast<std::size_t>(i / native_lanes)];
    dynamics_.set_state(x.q.data(), x.v.data());
    if (work == Work::InverseDerivatives) {
      dynamics_.inverse(x.tau.data(), lambda_.data());
      derivatives_.inverse(dynamics_);
      return derivatives_.rhs_q[0].lane(0);
    }
    dynamics_.forward(x.tau.data());
    if (work == Work::Forward) return dynamics_.a[0].lane(0);
    derivatives_.forward(dynamics_);
    return derivatives_.d_dq[0].lane(0);
  }

 private:
  struct State {
    std::vector<NativePack> q, v, tau;
  };
  static std::vector<NativePack> pack(const Eigen::MatrixXd& from, int first) {
    std::vector<NativePack> to(static_cast<std::size_t>(from.rows()));
    for (Eigen::Index i = 0; i < from.rows(); ++i)
      for (int l = 0; l < native_lanes; ++l)
        Lanes<NativePack>::set(to[static_cast<std::size_t>(i)], l, from(i, first + l));
    return to;
  }

  std::vector<State> packs_;
  ConstrainedDynamics<NativePack> dynamics_;
  ConstrainedDerivatives<NativePack> derivatives_;
  std::vector<NativePack> lambda_;
};

/// Evaluation of all states by the public API, including packing and unpacking.
class Batch {
 public:
  static constexpr int states_per_step = ring;
  static constexpr int lanes = native_lanes;
  Batch(const Model& model, const std::vector<ContactSpec>& specs, const States& states)
      : states_(states), dynamics_(model, specs, ring) {}

  double step(Work work, int /*i*/) {
    if (work == Work::Forward) {
      dynamics_.forward(states_.q, states_.v, states_.tau);
    } else {
      dynamics_.forward_with_derivatives(states_.q, states_.v, states_.tau);
    }
    return dynamics_.a(0)[0];
  }

 private:
  const States& states_;
  ContactDynamicsBatch dynamics_;
};

template <class Path>
void measure(benchmark::State& state, Work work, const Case& what, const std::string& reference) {
  const States states = states_near_reference(what.robot, ring);
  Path path(model_of(what.robot), what.specs(reference), states);
  int i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(path.step(work, i));
    i = (i + Path::states_per_step) % ring;
  }
  const auto count = static_cast<double>(state.iterations()) * Path::states_per_step;
  using benchmark::Counter;
  state.counters["time/state"] = Counter(count, Counter::kIsRate | Counter::kInvert);
  state.counters["states/s"] = Counter(count, Counter::kIsRate);
  state.SetLabel(std::to_string(Path::lanes) + (Path::lanes == 1 ? " lane" : " lanes"));
}

/// Measures the multiply-adds per second of one core, with enough independent sums in registers to
/// hide the latency.
template <class S>
void multiply_add_peak(benchmark::State& state) {
  constexpr int accumulators = 12, repeats = 1000;
  double one = 0.999;
  benchmark::DoNotOptimize(one);
  const S factor(one), term(1.0 - one);
  S sum[accumulators];
  for (int k = 0; k < accumulators; ++k) sum[k] = S(0.1 * k);
  for (auto _ : state)
    for (int r = 0; r < repeats; ++r)
#pragma GCC unroll 12
      for (int k = 0; k < accumulators; ++k) sum[k] = sum[k] * factor + term;
  for (int k = 1; k < accumulators; ++k) sum[0] += sum[k];
  benchmark::DoNotOptimize(sum[0]);
  using benchmark::Counter;
  const double count = static_cast<double>(state.iterations()) * accumulators * repeats;
  state.counters["multiply_adds/s"] = Counter(count * Lanes<S>::count, Counter::kIsRate);
  state.SetLabel(std::to_string(Lanes<S>::count) + (Lanes<S>::count == 1 ? " lane" : " lanes"));
}
BENCHMARK(multiply_add_peak<double>)->Name("multiply_add_peak/scalar");
BENCHMARK(multiply_add_peak<NativePack>)->Name("multiply_add_peak/pack");

template <class Path>
void add(const std::string& work_name, Work work, const std::string& path_name) {
  for (const Case& what : cases())
    for (const std::string& reference : references()) {
      const std::string name =
          work_name + "/" + what.label + "/" + what.contact + "/" + reference + "/" + path_name;
      benchmark::RegisterBenchmark(name.c_str(), measure<Path>, work, what, reference)
          ->Unit(benchmark::kMicrosecond);
    }
}

[[maybe_unused]] const bool all_added = [] {
  add<Scalar>("inverse_dynamics_derivatives", Work::InverseDerivatives, "scalar");
  add<PackedStates>("inverse_dynamics_derivatives", Work::InverseDerivatives, "pack");
  add<Scalar>("constrained_dynamics", Work::Forward, "scalar");
  add<PackedStates>("constrained_dynamics", Work::Forward, "pack");
  add<Batch>("constrained_dynamics", Work::Forward, "batch");
  add<Scalar>("constrained_derivatives", Work::ForwardDerivatives, "scalar");
  add<PackedStates>("constrained_derivatives", Work::ForwardDerivatives, "pack");
  add<Batch>("constrained_derivatives", Work::ForwardDerivatives, "batch");
  return true;
}();

}  // namespace
}  // namespace burnish::bench
