// Which vector instructions the kernels here were compiled for.
#pragma once

#include <string>

namespace burnish {

/// "AVX-512", "AVX2", "SSE2" or "NEON": of the library that the loader took. Kernels of another
/// set round otherwise.
std::string instruction_set();

}  // namespace burnish
