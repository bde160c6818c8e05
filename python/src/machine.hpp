// What objects with a workspace have in common in Python: used by one thread at a time, and
// failures of an evaluation as exceptions.
#pragma once

#include <atomic>
#include <string>

#include "burnish/base/error.hpp"
#include "burnish/base/status.hpp"

namespace burnish::python {

/// Becomes burnish.EvaluationError.
class EvaluationError : public Error {
 public:
  using Error::Error;
};

/// Throws EvaluationError for a status above NotConverged: "ContactDynamics.forward: ...".
void require(Status status, const char* what);

/// Python lets several threads call the same object while the interpreter's lock is released; its
/// workspace bears one.
class Busy {
 public:
  /// Held during a call. Throws Error if another thread's is.
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
