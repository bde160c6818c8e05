// What the processor could do at best, to measure kernels by.
#pragma once

namespace burnish {

/// Multiply-adds per second that one core reaches with as many states per register as packs hold
/// (pack_width()) and everything in registers: the best of short runs over about `seconds` s.
double multiply_add_peak(double seconds = 0.05);

}  // namespace burnish
