#include <ctime>
#include <stdexcept>

#include "burnish/base/error.hpp"
#include "fuzz/readers.hpp"

namespace burnish::fuzz {
namespace {

/// Processor time [s]; independent of other load on the machine.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

[[noreturn]] void fail(const Reader& reader, const std::string& problem) {
  throw std::logic_error("the reader of " + std::string(reader.name) + " " + problem);
}

}  // namespace

std::string run(const Reader& reader, const std::string& text) {
  const double start = seconds();
  std::string sentence;
  try {
    reader.read(text);
  } catch (const Error& refusal) {
    sentence = refusal.what();
    if (sentence.empty() || sentence.find('\n') != std::string::npos)
      fail(reader, "refuses without a sentence: '" + sentence + "'");
  } catch (const std::exception& error) {
    fail(reader, std::string("throws an exception other than Error: ") + error.what());
  }
  const double duration = seconds() - start;
  if (duration > 1.0) fail(reader, "takes " + std::to_string(duration) + " s");
  return sentence;
}

}  // namespace burnish::fuzz
