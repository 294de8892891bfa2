#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace pongsim::base {

/// Memory for objects that loops visit thousands of times a second. They lie close together in the order in which they
/// are made, in pages of 2 MiB where the kernel has them: few cache lines and few page table look-ups. Freed memory is
/// reused for objects of the same size. Not thread-safe.
class Arena {
 public:
  /// Alignment of each object [bytes]: a cache line, so that threads that work on different objects share none.
  static constexpr std::size_t kAlignment = 64;
  /// Size of the largest object [bytes].
  static constexpr std::size_t kLargest = 8192;

  Arena() = default;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  /// All objects must have been freed.
  ~Arena();

  /// @param bytes At most `kLargest`.
  /// @throws std::bad_alloc
  void* allocate(std::size_t bytes);
  /// @param bytes The size with which the memory was allocated.
  void free(void* memory, std::size_t bytes) noexcept;

  template <class T>
  struct Delete {
    Arena* arena = nullptr;
    void operator()(T* object) const {
      object->~T();
      arena->free(object, sizeof(T));
    }
  };
  template <class T>
  using Pointer = std::unique_ptr<T, Delete<T>>;

  /// @return An object that must not outlive this.
  template <class T, class... Arguments>
  Pointer<T> make(Arguments&&... arguments) {
    static_assert(sizeof(T) <= kLargest && alignof(T) <= kAlignment);
    void* const place = allocate(sizeof(T));
    try {
      return Pointer<T>(::new (place) T(std::forward<Arguments>(arguments)...), {this});
    } catch (...) {
      free(place, sizeof(T));
      throw;
    }
  }

 private:
  struct Free {
    Free* next;
  };

  void addBlock();

  std::vector<void*> blocks_;
  std::byte* next_ = nullptr;
  std::byte* end_ = nullptr;
  /// Lists of freed memory, by size in units of `kAlignment`.
  std::array<Free*, kLargest / kAlignment + 1> free_ = {};
};

}  // namespace pongsim::base
