// Makes the reader of YAML documents available in this namespace.
#pragma once

#include "document/reader.hpp"

namespace burnish::files {

using document::either;
using document::Reader;

}  // namespace burnish::files
