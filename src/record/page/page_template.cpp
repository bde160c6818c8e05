#include "record/page/page_template.hpp"

#ifdef BURNISH_PAGE_FILE
// The assembler copies the file unchanged. A C++ array of this size would compile slowly.
__asm__(
    ".section .rodata\n"
    ".global burnish_page_begin\n"
    ".global burnish_page_end\n"
    "burnish_page_begin:\n"
    ".incbin \"" BURNISH_PAGE_FILE
    "\"\n"
    "burnish_page_end:\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const char burnish_page_begin[], burnish_page_end[];
#endif

namespace burnish {

std::string_view page_template() {
#ifdef BURNISH_PAGE_FILE
  return {burnish_page_begin, burnish_page_end};
#else
  return {};
#endif
}

}  // namespace burnish
