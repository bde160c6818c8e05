#include "fuzz/readers.hpp"
#include "request.hpp"

namespace burnish::fuzz {
namespace {

void read(const std::string& text) { app::read_requests(text, "input.json", "nowhere"); }

}  // namespace

const Reader request{"request", read};

}  // namespace burnish::fuzz
