// Values of the task press_hold and its runs.
#pragma once

#include "press_hold/run_descriptions.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"
