// Random numbers that are the same on every machine: the standard fixes the engine's bits but not
// those of its distributions.
#pragma once

#include <cstdint>
#include <random>

namespace burnish {

/// One stream of a seed. Streams of different numbers are independent, so that switching one
/// disturbance on leaves the draws of the others as they were.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream) : engine_(mixed(seed, stream)) {}

  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Of mean 0 and deviation 1: the sum of twelve uniform numbers of 16 bits, which is exact in any
  /// floating point. It never leaves [-6, 6], and its kurtosis is 2.9 instead of 3.
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
  /// The finaliser of splitmix64 (S. Vigna, public domain) over both numbers.
  static std::uint64_t mixed(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15U * (stream + 1U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  std::mt19937_64 engine_;
};

/// Which stream of the seed each disturbance draws from.
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
