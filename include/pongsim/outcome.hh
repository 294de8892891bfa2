#pragma once

#include <optional>
#include <string>

namespace pongsim {

/// A value, or why it was refused.
template <class T>
struct Outcome {
  std::optional<T> value;
  /// One line without a full stop; empty if there is a value.
  std::string error;

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return value.value(); }
  T* operator->() { return &value.value(); }
};

}  // namespace pongsim
