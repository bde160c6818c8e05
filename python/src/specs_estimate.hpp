// Values of the estimate layer.
#pragma once

#include "estimate/descriptions.gen.hpp"
#include "specs_model.hpp"
