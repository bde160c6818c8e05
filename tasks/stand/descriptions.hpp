// What the task's specification holds, and its file.
#pragma once

#include "burnish/tasks/stand/stand.hpp"
#include "files/described_file.hpp"

namespace burnish::stand {

const Description& description_of(const Sway*);
const Description& description_of(const Weights*);
const Description& description_of(const Task*);
const files::DescribedFile& file_of(const Task*);

}  // namespace burnish::stand
