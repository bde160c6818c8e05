// The C++ side of python_calls.py: the same calls on the same states, read from a file.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "cases.hpp"

namespace burnish::bench {
namespace {

/// Rows of q, v and tau one after the other, as python_calls.py writes them.
States read_states(const char* file, const Model& model, int count) {
  States states{Eigen::MatrixXd(model.nq, count), Eigen::MatrixXd(model.nv, count),
                Eigen::MatrixXd(model.nv, count)};
  std::ifstream in(file, std::ios::binary);
  for (Eigen::MatrixXd* part : {&states.q, &states.v, &states.tau})
    in.read(reinterpret_cast<char*>(part->data()),
            static_cast<std::streamsize>(part->size()) * std::streamsize{sizeof(double)});
  if (!in) throw Error(std::string(file) + ": holds fewer numbers than the states take");
  return states;
}

/// Microseconds per state, the least of some repetitions of pass(first, end) on every piece of the
/// states. Small pieces find a quiet moment of a busy machine.
template <class Pass>
double least(int count, int piece, int repetitions, const Pass& pass) {
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  for (int r = 0; r < repetitions; ++r)
    for (int first = 0; first + piece <= count; first += piece) {
      const auto start = Clock::now();
      pass(first, first + piece);
      const std::chrono::duration<double, std::micro> took = Clock::now() - start;
      best = std::min(best, took.count() / piece);
    }
  return best;
}

void measure(const char* file, int count, int piece, int repetitions) {
  const auto what = std::find_if(cases().begin(), cases().end(), [](const Case& c) {
    return c.label == "talos_right_arm" && c.contact == "3D";
  });
  const Model& model = model_of(what->robot);
  const auto specs = what->specs("centered");
  const States x = read_states(file, model, count);

  ContactDynamics one(model, specs);
  double sum = 0.0;
  const auto print = [&](const char* name, double microseconds) {
    std::printf("%s %.6f\n", name, microseconds);
  };
  print("forward", least(count, piece, repetitions, [&](int first, int end) {
          for (int i = first; i < end; ++i) {
            one.forward(x.q.col(i), x.v.col(i), x.tau.col(i));
            sum += one.a()[0];
          }
        }));
  print("derivatives", least(count, piece, repetitions, [&](int first, int end) {
          for (int i = first; i < end; ++i) {
            one.forward(x.q.col(i), x.v.col(i), x.tau.col(i));
            one.forward_derivatives();
            sum += one.da_dq()(0, 0);
          }
        }));
  for (const int threads : {1, 2}) {
    ContactDynamicsBatch all(model, specs, count, {}, threads);
    print(threads == 1 ? "batch" : "batch2", least(count, count, repetitions, [&](int, int) {
            all.forward_with_derivatives(x.q, x.v, x.tau);
            sum += all.da_dq(0)(0, 0);
          }));
  }
  std::printf("sum %.9e\n", sum);
}

}  // namespace
}  // namespace burnish::bench

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: burnish_calls_bench STATES COUNT PIECE REPETITIONS (see python_calls.py)\n",
               stderr);
    return 2;
  }
  try {
    burnish::bench::measure(argv[1], std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]));
  } catch (const burnish::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
