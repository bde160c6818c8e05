// Descriptions of the structs of push_wall, and of its task file.
#pragma once

#include "files/described_file.hpp"
#include "push_wall/descriptions.gen.hpp"

namespace burnish::push_wall {

const files::DescribedFile& file_of(const Task*);

}  // namespace burnish::push_wall
