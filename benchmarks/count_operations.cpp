// Floating-point operations per state, from kernels on a scalar that counts operations.
#include "derivatives/count_operations.hpp"

#include <cstdio>

#include "cases.hpp"

namespace burnish::bench {
namespace {

void print(const char* work, const Case& what, const std::string& reference,
           const Operations& done) {
  std::printf("%-28s %-15s %-4s %-8s %8ld %8ld %6ld %5ld %5ld\n", work, what.label.c_str(),
              what.contact.c_str(), reference.c_str(), done.multiply, done.add, done.divide,
              done.root, done.trigonometric);
}

void count(const Case& what, const std::string& reference) {
  const States state = states_near_reference(what.robot, 1);
  const OperationCounts counts = count_operations(model_of(what.robot), what.specs(reference),
                                                  state.q.col(0), state.v.col(0), state.tau.col(0));
  print("inverse_dynamics_derivatives", what, reference, counts.inverse_derivatives);
  print("constrained_dynamics", what, reference, counts.dynamics);
  print("constrained_derivatives", what, reference, counts.derivatives);
}

}  // namespace
}  // namespace burnish::bench

int main() {
  using namespace burnish::bench;
  std::printf("%-28s %-15s %-4s %-8s %8s %8s %6s %5s %5s\n", "work", "robot", "", "", "multiply",
              "add", "divide", "root", "trig");
  for (const Case& what : cases())
    for (const std::string& reference : references()) count(what, reference);
}
