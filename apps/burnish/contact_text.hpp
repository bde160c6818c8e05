// Parser of contacts on the command line. A contact is given in one word.
#pragma once

#include <string>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish::app {

/// Reads a contact such as
/// "tool=left_sole_link,reference=surface,normal=0,0.2,1,directions=z,rx,ry,kd=50". The notation of
/// files, in braces, is accepted too. The keys are those of a contact in a file; "normal" is a key
/// of a surface. A word without "=" continues the values of the previous key. The default of
/// `target` is the placement of the tool at q. Throws Error for malformed text.
ContactSpec parse_contact(const std::string& text, const Model& model, const Eigen::VectorXd& q);

}  // namespace burnish::app
