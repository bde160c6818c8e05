// C++ part of python_calls.py. It measures the calls that the Python part measures, at the same
// states, which it reads from a file.
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

/// Reads the states that python_calls.py writes: all of q, then v, then tau.
States read_states(const char* file, const Model& model, int count) {
  States states{Eigen::MatrixXd(model.nq, count), Eigen::MatrixXd(model.nv, count),
                Eigen::MatrixXd(model.nv, count)};
  std::ifstream in(file, std::ios::binary);
  for (Eigen::MatrixXd* matrix : {&states.q, &states.v, &states.tau})
    in.read(reinterpret_cast<char*>(matrix->data()),
            static_cast<std::streamsize>(matrix->size()) * std::streamsize{sizeof(double)});
  if (!in) throw Error(std::string(file) + ": the file ends before the last state");
  return states;
}

/// Calls pass(first, end) repeatedly for each piece of the states, and returns the smallest time
/// per state [us]. Small pieces are less affected by other load of the machine.
template <class Pass>
double min_time(int count, int piece, int repetitions, const Pass& pass) {
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
  print("forward", min_time(count, piece, repetitions, [&](int first, int end) {
          for (int i = first; i < end; ++i) {
            one.forward(x.q.col(i), x.v.col(i), x.tau.col(i));
            sum += one.a()[0];
          }
        }));
  print("derivatives", min_time(count, piece, repetitions, [&](int first, int end) {
          for (int i = first; i < end; ++i) {
            one.forward(x.q.col(i), x.v.col(i), x.tau.col(i));
            one.forward_derivatives();
            sum += one.da_dq()(0, 0);
          }
        }));
  for (const int threads : {1, 2}) {
    ContactDynamicsBatch all(model, specs, count, {}, threads);
    print(threads == 1 ? "batch" : "batch2", min_time(count, count, repetitions, [&](int, int) {
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
