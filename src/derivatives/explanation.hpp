// A status in one sentence, with the names of what is to blame.
#pragma once

#include <string>
#include <vector>

#include "burnish/base/status.hpp"

namespace burnish {

/// describe(status), which for a SingularMass names the joints that move no mass, each once, and
/// for SingularContacts the rows ("pad/z") that depend on those before them, or the contacts whose
/// tool jams.
std::string explain(Status status, const std::vector<std::string>& joints,
                    const std::vector<std::string>& rows, const std::vector<std::string>& jammed);

}  // namespace burnish
