// Random numbers that are identical on all machines. The C++ standard specifies the bits of its
// random engines, but not those of its distributions.
#pragma once

#include <cstdint>
#include <random>

namespace burnish {

/// Stream of random numbers, determined by a seed and a stream number. Streams with different
/// numbers are independent. A new disturbance therefore does not change the random numbers of
/// others.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream) : engine_(mixed(seed, stream)) {}

  /// Returns a uniformly distributed number in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Returns a uniformly distributed number in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Returns an approximately normal number with mean 0 and standard deviation 1. It is the sum of
  /// twelve uniform numbers of 16 bits, minus the mean of this sum. The sum is exact in double
  /// precision. The result is in [-6, 6] and has a kurtosis of 2.9 (normal: 3).
  double normal() {
    std::int64_t sum = 0;
    for (int draw = 0; draw < 3; ++draw) {
      const std::uint64_t bits = engine_();
      for (int piece = 0; piece < 4; ++piece)
        sum += static_cast<std::int64_t>((bits >> (16 * piece)) & 0xffffU);
    }
    return static_cast<double>(sum - 393210) * 0x1p-16;
  }

 private:
  /// Combines seed and stream number by the finaliser of splitmix64 (S. Vigna, public domain).
  static std::uint64_t mixed(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15U * (stream + 1U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  std::mt19937_64 engine_;
};

/// Stream number of each random disturbance.
namespace streams {
enum : std::uint64_t {
  torque_scale,
  torque_bias,
  torque_noise,
  torque_loop,
  torque_sensor,
  position,
  velocity,
  force,
  support,
  payload,
  gyro,
  accelerometer
};
}  // namespace streams

}  // namespace burnish
