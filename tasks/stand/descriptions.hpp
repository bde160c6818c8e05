// Descriptions of the structs of stand, and of its task file.
#pragma once

#include "files/described_file.hpp"
#include "stand/descriptions.gen.hpp"

namespace burnish::stand {

const files::DescribedFile& file_of(const Task*);

}  // namespace burnish::stand
