#include "dynamics/instruction_set.hpp"

namespace burnish {

std::string instruction_set() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__aarch64__)
  return "NEON";
#else
  return "SSE2";
#endif
}

}  // namespace burnish
