// Memory for doubles, aligned to cache lines so that whole vectors can be loaded.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace burnish {

/// A zero-initialised block of fixed size, freed with the object.
class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(std::size_t size)
      : data_(static_cast<double*>(::operator new[](size * sizeof(double), alignment))) {
    for (std::size_t i = 0; i < size; ++i) data_[i] = 0.0;
  }
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(double* memory) const { ::operator delete[](memory, alignment); }
  };
  std::unique_ptr<double[], Free> data_;
};

}  // namespace burnish
