// What the task's specification holds, and its file.
#pragma once

#include "files/described_file.hpp"
#include "stand/descriptions.gen.hpp"

namespace burnish::stand {

const files::DescribedFile& file_of(const Task*);

}  // namespace burnish::stand
