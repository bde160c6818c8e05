// The reader of what files hold.
#pragma once

#include "document/reader.hpp"

namespace burnish::files {

using document::either;
using document::Reader;

}  // namespace burnish::files
