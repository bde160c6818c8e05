// What a controller is: see mpc/controller.hpp.
#pragma once

#include "burnish/mpc/controller.hpp"
