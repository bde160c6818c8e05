// Values of the task push_wall and its runs.
#pragma once

#include "push_wall/run_descriptions.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"
