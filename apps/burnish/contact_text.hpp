// A contact in one word of a command line.
#pragma once

#include <string>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish::app {

/// Reads "tool=left_sole_link,reference=surface,normal=0,0.2,1,directions=z,rx,ry,kd=50": keys are
/// those of a contact in a file and "normal" (a surface's); what follows a comma without a key
/// belongs to the key before. Or the contact as a file states it, in braces. Its target, unless
/// said, is where the tool is at q. Throws Error.
ContactSpec parse_contact(const std::string& text, const Model& model, const Eigen::VectorXd& q);

}  // namespace burnish::app
