// The page of runs as it comes out of web/, without data.
#pragma once

#include <string_view>

namespace burnish {

/// Its text; empty where the page was not built.
std::string_view page_template();

}  // namespace burnish
