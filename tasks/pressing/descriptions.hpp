// What specifications of tasks that press hold.
#pragma once

#include "base/description.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish {

const Description& description_of(const ToolLimits*);

}  // namespace burnish
