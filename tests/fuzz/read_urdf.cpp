#include "burnish/model/model.hpp"
#include "burnish/urdf/urdf.hpp"
#include "fuzz/readers.hpp"

namespace burnish::fuzz {
namespace {

void read(const std::string& text) {
  const TreeSpec tree = parse_urdf(text, "input.urdf");
  ModelOptions floating;
  floating.base = Base::FreeFlyer;
  try {
    build_model(tree, floating);
  } catch (const Error&) {
    // A fixed base has fewer requirements, so the model is built with it as well.
  }
  build_model(tree, {});
}

}  // namespace

const Reader urdf{"urdf", read};

}  // namespace burnish::fuzz
