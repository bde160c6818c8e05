// Format of the polishing task's file.
#pragma once

#include "files/described_file.hpp"
#include "polishing/descriptions.gen.hpp"

namespace burnish::polishing {

const files::DescribedFile& file_of(const Task*);
/// Returns a checked task with the texts from which the task was read. Throws Error for an invalid
/// task, as read_task() does.
files::SpecTexts<Task> parse_said_task(const std::string& text, const std::string& name,
                                       const std::vector<files::Override>& overrides = {});

}  // namespace burnish::polishing
