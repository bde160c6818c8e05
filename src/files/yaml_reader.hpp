// The reader of what files hold.
#pragma once

#include "document/reader.hpp"

namespace burnish::files {

using YamlReader = document::Reader;
using document::either;

}  // namespace burnish::files
