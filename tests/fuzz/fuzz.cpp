// A reader under libFuzzer, which calls this with one text after the other; which reader is a
// definition of the build. What run() throws ends the program, and libFuzzer keeps the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fuzz/readers.hpp"

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*words*/) {
  unsetenv("BURNISH_ROBOTS");  // robots by name are those of the source tree
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  burnish::fuzz::run(burnish::fuzz::BURNISH_FUZZ_READER, std::string(data, data + size));
  return 0;
}
