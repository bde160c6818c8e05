// The task's file.
#pragma once

#include "files/described_file.hpp"
#include "polishing/descriptions.gen.hpp"

namespace burnish::polishing {

const files::DescribedFile& file_of(const Task*);
/// A checked task, and what said it. Throws Error as read_task() does.
files::Said<Task> parse_said_task(const std::string& text, const std::string& name,
                                  const std::vector<files::Override>& overrides = {});

}  // namespace burnish::polishing
