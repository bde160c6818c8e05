// Computing time per stage of the Riccati recursion over 100 knots, compared with a recursion
// written with Eigen's dense products. `riccati/structured`: SecondOrder form; `riccati/dense`:
// dynamics as one dense matrix; `riccati/two_workers`: SecondOrder form by two threads;
// `riccati/eigen`: the reference with Eigen. Arguments: nv, filtered, nu.
#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <random>
#include <vector>

#include "base/thread_pool.hpp"
#include "burnish/base/views.hpp"
#include "solver/riccati.hpp"

namespace burnish::bench {
namespace {

constexpr int horizon = 100;

struct Stage {
  RowMatrix hessian, dense, velocity;
  Eigen::VectorXd gradient, gap, decay;
};

struct Horizon {
  Horizon(int nv, int filtered, int nu) : nv_(nv), filtered_(filtered), nu_(nu) {
    ndx_ = 2 * nv + filtered;
    nz_ = nu + ndx_;
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto draw = [&](int rows, int columns) {
      return RowMatrix(RowMatrix::NullaryExpr(rows, columns, [&] { return normal(random); }));
    };
    for (int k = 0; k <= horizon; ++k) {
      Stage s;
      const RowMatrix root = draw(nz_, nz_);
      s.hessian = root * root.transpose() / nz_ + RowMatrix::Identity(nz_, nz_);
      s.gradient = draw(nz_, 1);
      s.gap = 0.01 * draw(ndx_, 1);
      s.velocity = 0.3 * draw(nv, nz_) / std::sqrt(nz_);
      s.velocity.middleCols(nu + nv, nv) += RowMatrix::Identity(nv, nv);
      s.decay = Eigen::VectorXd::Constant(filtered, 0.7);
      s.dense = RowMatrix::Zero(ndx_, nz_);
      s.dense.topRows(nv) = step * s.velocity;
      s.dense.middleRows(nv, nv) = s.velocity;
      s.dense.block(0, nu, nv, nv) += RowMatrix::Identity(nv, nv);
      for (int i = 0; i < filtered; ++i) {
        s.dense(2 * nv + i, nu + 2 * nv + i) = 0.7;
        s.dense(2 * nv + i, i) = 0.3;
      }
      stages_.push_back(s);
    }
  }

  static constexpr double step = 0.01;
  int nv_, filtered_, nu_, ndx_ = 0, nz_ = 0;
  std::vector<Stage> stages_;
};

/// Memory in the layout of the solver: an expansion, a policy and a value function per knot.
class Recursion {
 public:
  Recursion(const Horizon& horizon_data, DynamicsForm form, int workers = 1)
      : h_(horizon_data),
        state_{h_.ndx_, h_.ndx_, h_.nv_, h_.filtered_, {}},
        recursion_(state_, h_.nu_, workers) {
    const RiccatiLayout& layout = recursion_.layout();
    for (int k = 0; k <= horizon; ++k) {
      const auto size = [](int rows, int stride) {
        return static_cast<std::size_t>(rows * stride);
      };
      memory_.emplace_back(size(layout.expansion_rows + h_.ndx_ + 2, layout.expansion_stride) +
                           static_cast<std::size_t>(layout.spare));
      value_.emplace_back(size(h_.ndx_ + 1, layout.value_stride) +
                          static_cast<std::size_t>(layout.spare));
      policy_.emplace_back(size(h_.nu_ + 1, layout.gain_stride) +
                           static_cast<std::size_t>(layout.spare));
      gaps_.emplace_back(size(2, layout.value_stride));
      expansion_.push_back(fill(k, form, memory_.back().data()));
    }
  }

  double sweep(const ThreadTeam& team = {}) {
    if (team.leads()) recursion_.terminal(expansion_[horizon], value(horizon));
    team.meet();
    for (int k = horizon - 1; k >= 0; --k)
      recursion_.step({expansion_[k], h_.nu_, gaps_[k].data() + recursion_.layout().value_stride,
                       value(k + 1), policy(k), value(k), gaps_[k].data()},
                      {.regularization = 1e-9}, team);
    return value(0).hessian[0];
  }
  double multiplications() const {
    return recursion_.multiplications(h_.nu_, expansion_.front().form);
  }

 private:
  ValueStorage value(int k) {
    double* m = value_[static_cast<std::size_t>(k)].data();
    return {m, m + recursion_.layout().value_stride};
  }
  PolicyStorage policy(int k) {
    double* m = policy_[static_cast<std::size_t>(k)].data();
    return {m, m + recursion_.layout().gain_stride};
  }
  KnotExpansion fill(int k, DynamicsForm form, double* m) {
    const RiccatiLayout& layout = recursion_.layout();
    const Stage& s = h_.stages_[static_cast<std::size_t>(k)];
    const int stride = layout.expansion_stride;
    KnotExpansion e;
    e.stride = stride;
    e.gradient = m;
    e.hessian = m + stride;
    e.dynamics = e.hessian + layout.expansion_rows * stride;
    e.decay = e.dynamics + h_.ndx_ * stride;
    e.step = Horizon::step;
    e.form = form;
    const int nu = k == horizon ? 0 : h_.nu_;
    const int skipped = h_.nu_ - nu;
    const int nz = nu + h_.ndx_;
    const RowMatrix& dynamics = form == DynamicsForm::Dense ? s.dense : s.velocity;
    for (int i = 0; i < nz; ++i) {
      e.gradient[i] = s.gradient[skipped + i];
      for (int j = 0; j <= i; ++j) e.hessian[i * stride + j] = s.hessian(skipped + i, skipped + j);
    }
    for (Eigen::Index i = 0; i < dynamics.rows(); ++i)
      for (int j = 0; j < nz; ++j) e.dynamics[i * stride + j] = dynamics(i, j);
    for (int i = 0; i < h_.filtered_; ++i) e.decay[i] = s.decay[i];
    for (int i = 0; i < h_.ndx_; ++i) gaps_.back().data()[layout.value_stride + i] = s.gap[i];
    return e;
  }

  const Horizon& h_;
  StateShape state_;
  RiccatiRecursion recursion_;
  std::vector<Buffer> memory_, value_, policy_, gaps_;
  std::vector<KnotExpansion> expansion_;
};

/// Textbook recursion with column-major Eigen matrices, without allocations in the sweep.
class EigenRecursion {
 public:
  explicit EigenRecursion(const Horizon& h) : nu_(h.nu_), ndx_(h.ndx_) {
    for (const Stage& s : h.stages_) {
      fx_.emplace_back(s.dense.rightCols(ndx_));
      fu_.emplace_back(s.dense.leftCols(nu_));
      lxx_.emplace_back(s.hessian.bottomRightCorner(ndx_, ndx_));
      lux_.emplace_back(s.hessian.topRightCorner(nu_, ndx_));
      luu_.emplace_back(s.hessian.topLeftCorner(nu_, nu_));
      lx_.emplace_back(s.gradient.tail(ndx_));
      lu_.emplace_back(s.gradient.head(nu_));
      gap_.emplace_back(s.gap);
    }
    vxx_ = lxx_;
    vx_ = lx_;
    gain_ = lux_;
    feedforward_ = lu_;
    qxx_ = lxx_[0];
    fv_x_ = lxx_[0];
    fv_u_ = lux_[0];
    qux_ = lux_[0];
    quu_ = luu_[0];
    w_ = qx_ = lx_[0];
    qu_ = lu_[0];
    factor_ = Eigen::LLT<Eigen::MatrixXd>(nu_);
  }

  double sweep() {
    for (int i = horizon - 1; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      w_ = vx_[k + 1];
      w_.noalias() += vxx_[k + 1] * gap_[k];
      fv_x_.noalias() = fx_[k].transpose() * vxx_[k + 1];
      fv_u_.noalias() = fu_[k].transpose() * vxx_[k + 1];
      qxx_ = lxx_[k];
      qxx_.noalias() += fv_x_ * fx_[k];
      qux_ = lux_[k];
      qux_.noalias() += fv_u_ * fx_[k];
      quu_ = luu_[k];
      quu_.noalias() += fv_u_ * fu_[k];
      qx_ = lx_[k];
      qx_.noalias() += fx_[k].transpose() * w_;
      qu_ = lu_[k];
      qu_.noalias() += fu_[k].transpose() * w_;
      factor_.compute(quu_);
      gain_[k] = -qux_;
      factor_.solveInPlace(gain_[k]);
      feedforward_[k] = -qu_;
      factor_.solveInPlace(feedforward_[k]);
      vx_[k] = qx_;
      vx_[k].noalias() += gain_[k].transpose() * qu_;
      qxx_.noalias() += qux_.transpose() * gain_[k];
      vxx_[k] = 0.5 * (qxx_ + qxx_.transpose());
    }
    return vxx_[0](0, 0);
  }

 private:
  int nu_, ndx_;
  std::vector<Eigen::MatrixXd> fx_, fu_, lxx_, lux_, luu_, vxx_, gain_;
  std::vector<Eigen::VectorXd> lx_, lu_, gap_, vx_, feedforward_;
  Eigen::MatrixXd qxx_, qux_, quu_, fv_x_, fv_u_;
  Eigen::VectorXd w_, qx_, qu_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

template <class Sweeper>
void run(benchmark::State& state, Sweeper& sweeper) {
  for (auto _ : state) benchmark::DoNotOptimize(sweeper.sweep());
  state.counters["time/stage"] = benchmark::Counter(
      horizon, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

Horizon horizon_of(const benchmark::State& state) {
  return {static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
          static_cast<int>(state.range(2))};
}

void structured(benchmark::State& state) {
  const Horizon h = horizon_of(state);
  Recursion recursion(h, DynamicsForm::SecondOrder);
  run(state, recursion);
}
/// Measures the structured recursion by two threads, and reports the number of multiplications,
/// from which a solver decides whether to use several threads.
void shared(benchmark::State& state) {
  const Horizon h = horizon_of(state);
  Recursion recursion(h, DynamicsForm::SecondOrder, 2);
  ThreadPool pool(2);
  const ThreadPool::Awake awake(pool);
  for (auto _ : state)
    pool.together(
        [&](const ThreadTeam& team) noexcept { benchmark::DoNotOptimize(recursion.sweep(team)); });
  state.counters["time/stage"] = benchmark::Counter(
      horizon, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["multiplications"] = recursion.multiplications();
}
void dense(benchmark::State& state) {
  const Horizon h = horizon_of(state);
  Recursion recursion(h, DynamicsForm::Dense);
  run(state, recursion);
}
void eigen(benchmark::State& state) {
  const Horizon h = horizon_of(state);
  EigenRecursion recursion(h);
  run(state, recursion);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"nv", "filtered", "nu"});
  b->Args({6, 0, 6})->Args({6, 6, 6})->Args({38, 0, 32});
}
void sizes_to_share(benchmark::internal::Benchmark* b) {
  b->ArgNames({"nv", "filtered", "nu"})->UseRealTime();
  for (const int nv : {12, 16, 20, 24, 30, 36}) b->Args({nv, 0, nv - 6});
}
BENCHMARK(structured)->Name("riccati/structured")->Apply(sizes);
BENCHMARK(structured)->Name("riccati/structured")->Apply(sizes_to_share);
BENCHMARK(shared)->Name("riccati/two_workers")->Apply(sizes_to_share);
BENCHMARK(dense)->Name("riccati/dense")->Apply(sizes);
BENCHMARK(eigen)->Name("riccati/eigen")->Apply(sizes);

}  // namespace
}  // namespace burnish::bench
