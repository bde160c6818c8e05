#include <ctime>
#include <stdexcept>

#include "burnish/base/error.hpp"
#include "fuzz/readers.hpp"

namespace burnish::fuzz {
namespace {

/// Processor time, which grows no faster on a machine that is busy.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

[[noreturn]] void fail(const Reader& reader, const std::string& what) {
  throw std::logic_error("the reader of " + std::string(reader.name) + " " + what);
}

}  // namespace

std::string run(const Reader& reader, const std::string& text) {
  const double begun = seconds();
  std::string sentence;
  try {
    reader.read(text);
  } catch (const Error& refusal) {
    sentence = refusal.what();
    if (sentence.empty() || sentence.find('\n') != std::string::npos)
      fail(reader, "refuses with no sentence: '" + sentence + "'");
  } catch (const std::exception& error) {
    fail(reader, std::string("throws what is no Error: ") + error.what());
  }
  const double took = seconds() - begun;
  if (took > 1.0) fail(reader, "takes " + std::to_string(took) + " s");
  return sentence;
}

}  // namespace burnish::fuzz
