// Conversion of the types of the task push_wall and its runs between Python and C++.
#pragma once

#include "push_wall/run_descriptions.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"
