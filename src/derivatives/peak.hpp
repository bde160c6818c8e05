// Peak arithmetic throughput of the processor, for benchmarks of kernels.
#pragma once

namespace burnish {

/// Measures the multiply-adds per second of one core on packs (pack_width() numbers each) that stay
/// in registers. Makes short runs for about `seconds` [s] and returns the highest rate.
double multiply_add_peak(double seconds = 0.05);

}  // namespace burnish
