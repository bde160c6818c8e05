// Template of the run page, as built from web/, without data.
#pragma once

#include <string_view>

namespace burnish {

/// Returns the text of the template; empty if the page was not built.
std::string_view page_template();

}  // namespace burnish
