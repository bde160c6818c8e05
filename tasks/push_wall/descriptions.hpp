// What the task's specification holds, and its file.
#pragma once

#include "burnish/tasks/push_wall/push_wall.hpp"
#include "files/described_file.hpp"

namespace burnish::push_wall {

const Description& description_of(const Weights*);
const Description& description_of(const Wall*);
const Description& description_of(const Lean*);
const Words& words_of(Limit);
const Description& description_of(const Task*);
const files::DescribedFile& file_of(const Task*);

}  // namespace burnish::push_wall
