// Conversion of the types of the task stand and its runs between Python and C++.
#pragma once

#include "specs_model.hpp"
#include "specs_pressing.hpp"
#include "stand/run_descriptions.hpp"
