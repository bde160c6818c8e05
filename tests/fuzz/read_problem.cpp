#include "files/read_problem.hpp"

#include "fuzz/readers.hpp"

namespace burnish::fuzz {
namespace {

void read(const std::string& text) {
  files::read_problem(document::Reader::parse(text, "input.yaml"), "nowhere");
}

}  // namespace

const Reader problem{"problem", read};

}  // namespace burnish::fuzz
