// A contact as JSON states it.
#pragma once

#include "burnish/contact/contact.hpp"
#include "json_reader.hpp"

namespace burnish::app {

ContactSpec read_contact(const JsonReader& reader);

/// "local", or {"type": "surface", "normal": [..]} or with "rotation": three rows.
Reference read_reference(const JsonReader& reader);

}  // namespace burnish::app
