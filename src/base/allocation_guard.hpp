// Counts the allocations in a scope, including those of operator new and Eigen. The file
// allocation_guard.cpp replaces malloc and related functions of the C library for the whole
// process. Only programs link this file; the libraries do not contain it.
#pragma once

namespace burnish {

/// Counter of the allocations of this thread since construction. Guards may be nested.
class AllocationGuard {
 public:
  AllocationGuard();
  /// Number of calls of malloc, calloc, realloc, memalign and related functions since construction.
  /// Calls of free are not counted.
  long count() const;

  /// Reason why this build cannot count allocations, or nullptr. Sanitizers have their own malloc,
  /// and C libraries other than glibc do not give access to the original malloc.
  static const char* unavailable();

 private:
  long before_;
};

}  // namespace burnish
