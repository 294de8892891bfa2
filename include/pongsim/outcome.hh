#pragma once

#include <optional>
#include <string>

namespace pongsim {

/// The result of something that can be refused: a value, or why there is none. True if it was done.
template <class T>
struct Outcome {
  std::optional<T> value;
  /// One line without a full stop; empty if there is a value.
  std::string error;

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return value.value(); }
  T* operator->() { return &value.value(); }
};

/// Likewise of something that has no value.
template <>
struct Outcome<void> {
  /// One line without a full stop; empty if it was done.
  std::string error;

  explicit operator bool() const { return error.empty(); }
};

}  // namespace pongsim
