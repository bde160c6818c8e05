// Descriptions of the structs of press_hold, and of its task file.
#pragma once

#include "files/described_file.hpp"
#include "press_hold/descriptions.gen.hpp"

namespace burnish::press_hold {

const files::DescribedFile& file_of(const Task*);

}  // namespace burnish::press_hold
