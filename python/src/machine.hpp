// Common parts of Python objects that have a workspace: lock for use by one thread at a time,
// exception for failed evaluations.
#pragma once

#include <atomic>
#include <string>

#include "burnish/base/error.hpp"
#include "burnish/base/status.hpp"

namespace burnish::python {

/// C++ counterpart of burnish.EvaluationError.
class EvaluationError : public Error {
 public:
  using Error::Error;
};

/// Throws EvaluationError for a status worse than NotConverged: "ContactDynamics.forward: ...".
void require(Status status, const char* what);

/// Lock of an object. Without the GIL, several threads can call an object at the same time, but its
/// workspace supports only one thread.
class Busy {
 public:
  /// Holds the lock during a call. Throws Error if another thread holds it.
  class Lock {
   public:
    Lock(Busy& busy, const char* what);
    ~Lock() { busy_.taken_.clear(std::memory_order_release); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

   private:
    Busy& busy_;
  };

 private:
  std::atomic_flag taken_;
};

}  // namespace burnish::python
