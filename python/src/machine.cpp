#include "machine.hpp"

namespace burnish::python {

void require(Status status, const char* what) {
  if (!is_usable(status))
    throw EvaluationError(std::string(what) + ": " + std::string(describe(status)));
}

Busy::Lock::Lock(Busy& busy, const char* what) : busy_(busy) {
  if (busy.taken_.test_and_set(std::memory_order_acquire))
    throw Error(std::string(what) + ": in use by another thread; wanted one object per thread");
}

}  // namespace burnish::python
