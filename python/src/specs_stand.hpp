// Values of the task stand and its runs.
#pragma once

#include "specs_model.hpp"
#include "specs_pressing.hpp"
#include "stand/run_descriptions.hpp"
