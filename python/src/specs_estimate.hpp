// Conversion of the types of the estimate layer between Python and C++.
#pragma once

#include "estimate/descriptions.gen.hpp"
#include "specs_model.hpp"
