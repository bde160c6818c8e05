// A contact in one word of a command line.
#pragma once

#include <string>

#include "burnish/contact/contact.hpp"

namespace burnish::app {

/// Reads "tool=left_sole_link,reference=surface,normal=0,0.2,1,directions=z,rx,ry,kd=50": keys are
/// those of ContactSpec and "normal" (a surface's); what follows a comma without a key belongs to
/// the key before. Throws Error.
ContactSpec parse_contact(const std::string& text);

}  // namespace burnish::app
