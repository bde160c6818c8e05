// Conversion of the types of the task press_hold and its runs between Python and C++.
#pragma once

#include "press_hold/run_descriptions.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"
