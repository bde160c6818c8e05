// Counts what a scope allocates. allocation_guard.cpp, which is part of a program and of no
// library, defines malloc and its relatives, which then stand before those of the C library: every
// allocation of the process goes through them, operator new and Eigen's included.
#pragma once

namespace burnish {

/// Counts the allocations of this thread from its construction on. Guards may nest.
class AllocationGuard {
 public:
  AllocationGuard();
  /// malloc, calloc, realloc, memalign and their relatives called since; free is not counted.
  long count() const;

  /// Why nothing can be counted in this build, or nullptr: sanitizers put their own malloc in
  /// place, and other C libraries than glibc offer no way to reach the original.
  static const char* unavailable();

 private:
  long before_;
};

}  // namespace burnish
