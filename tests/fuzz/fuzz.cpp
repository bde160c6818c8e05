// Entry of a fuzz target: libFuzzer calls the reader that the build selects with one text after
// another. An exception from run() ends the program, and libFuzzer saves the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fuzz/readers.hpp"

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*words*/) {
  unsetenv("BURNISH_ROBOTS");  // loads named robots from the source tree
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  burnish::fuzz::run(burnish::fuzz::BURNISH_FUZZ_READER, std::string(data, data + size));
  return 0;
}
