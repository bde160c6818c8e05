// Values of the estimate layer.
#pragma once

#include "estimate/descriptions.hpp"
#include "specs_model.hpp"
