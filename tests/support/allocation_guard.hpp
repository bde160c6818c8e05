// Counts the allocations of a scope in tests.
#pragma once

#include "base/allocation_guard.hpp"

/// Skips the test, with the reason, if allocations cannot be counted.
#define BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD()  \
  if (::burnish::AllocationGuard::unavailable()) \
  GTEST_SKIP() << ::burnish::AllocationGuard::unavailable()
