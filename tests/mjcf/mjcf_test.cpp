#include "burnish/mjcf/mjcf.hpp"

#include <gtest/gtest.h>
