#include "base/allocation_guard.hpp"

#include <cerrno>
#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BURNISH_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define BURNISH_SANITIZED 1
#endif
#endif

#if defined(__GLIBC__) && !defined(BURNISH_SANITIZED)
#define BURNISH_COUNTS_ALLOCATIONS 1
#endif

namespace burnish {
namespace {
thread_local long allocations = 0;
}  // namespace

AllocationGuard::AllocationGuard() : before_(allocations) {}
long AllocationGuard::count() const { return allocations - before_; }

const char* AllocationGuard::unavailable() {
#if defined(BURNISH_COUNTS_ALLOCATIONS)
  return nullptr;
#elif defined(BURNISH_SANITIZED)
  return "allocations cannot be counted in a build with a sanitizer, which has its own malloc";
#else
  return "allocations can be counted with glibc only";
#endif
}

}  // namespace burnish

#if defined(BURNISH_COUNTS_ALLOCATIONS)
// Original functions of glibc, under the names that glibc offers to programs that replace malloc.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++burnish::allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  ++burnish::allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  ++burnish::allocations;
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++burnish::allocations;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}
#endif
