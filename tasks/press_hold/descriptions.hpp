// What the task's specification holds, and its file.
#pragma once

#include "burnish/tasks/press_hold/press_hold.hpp"
#include "files/described_file.hpp"

namespace burnish::press_hold {

const Description& description_of(const Task*);
const files::DescribedFile& file_of(const Task*);

}  // namespace burnish::press_hold
