#include "derivatives/peak.hpp"

#include <algorithm>
#include <chrono>

#include "math/pack.hpp"

namespace burnish {
namespace {

/// Hides the value from the optimizer, which could otherwise remove the measured work.
template <class T>
void hide(T& value) {
  asm volatile("" : "+m"(value));
}

// Number of independent sums: enough to hide the latency of multiply-adds, but all in registers.
constexpr int sums = 12;

void multiply_add(int repeats, NativePack& factor, NativePack& term, NativePack& result) {
  hide(factor);
  hide(term);
  NativePack sum[sums];
  for (int k = 0; k < sums; ++k) sum[k] = NativePack(0.1 * k);
  for (int r = 0; r < repeats; ++r)
#pragma GCC unroll 12
    for (int k = 0; k < sums; ++k) sum[k] = sum[k] * factor + term;
  for (int k = 0; k < sums; ++k) result += sum[k];
}

}  // namespace

double multiply_add_peak(double seconds) {
  using Clock = std::chrono::steady_clock;
  constexpr int repeats = 20000;
  NativePack factor(0.999), term(0.001), result(0.0);
  double best = 0.0;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  do {
    const auto start = Clock::now();
    multiply_add(repeats, factor, term, result);
    hide(result);
    const std::chrono::duration<double> spent = Clock::now() - start;
    best = std::max(best, static_cast<double>(repeats) * sums * native_lanes / spent.count());
  } while (Clock::now() < end);
  return best;
}

}  // namespace burnish
