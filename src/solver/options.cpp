#include "burnish/solver/options.hpp"

#include "base/sentence.hpp"
#include "solver/descriptions.gen.hpp"

namespace burnish {

void DdpOptions::check() const {
  check_ranges(description_of(this), this,
               [](const std::string& entry) { return "solver options: " + entry; });
  if (regularization.largest < regularization.smallest)
    throw Error("solver options: regularization.largest is " + number(regularization.largest) +
                "; wanted a number that is at least regularization.smallest");
}

}  // namespace burnish
