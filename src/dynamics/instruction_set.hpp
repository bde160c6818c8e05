// Vector instruction set for which the kernels were compiled.
#pragma once

#include <string>

namespace burnish {

/// Returns the instruction set of the loaded library: "AVX-512", "AVX2", "SSE2" or "NEON". Results
/// of different sets differ by rounding.
std::string instruction_set();

}  // namespace burnish
