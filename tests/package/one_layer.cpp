// Links only burnish::model.
#include "burnish/model/model.hpp"

int main() {
  burnish::TreeSpec tree;
  tree.name = "nothing";
  try {
    burnish::build_model(tree);
  } catch (const burnish::Error&) {
    return 0;  // no links: refused
  }
  return 1;
}
