#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <deque>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim {

/// Writes values to bytes, or reads them back in the same order; one function of the owner does both:
///
///     void transfer(StateArchive& archive) { archive(position_); archive(pid_); }
///
/// It handles numbers, the types of `types.hh`, strings, types with such a function, and optionals and lists of all
/// these. The bytes depend on this machine's number format.
class StateArchive {
 public:
  /// Writes values.
  StateArchive() = default;
  /// Reads values from `bytes`, which must outlive it.
  explicit StateArchive(std::span<const std::byte> bytes) : isGiving_(true), given_(bytes) {}

  /// @return Whether it reads instead of writing.
  bool isGiving() const { return isGiving_; }

  /// @throws std::out_of_range if there are no more bytes to read.
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void operator()(T& value) { transfer(&value, sizeof value); }
  void operator()(Time& time) {
    Time::rep count = time.count();
    (*this)(count);
    time = Time(count);
  }
  void operator()(Vector3& vector) { transfer(vector.data(), 3 * sizeof(double)); }
  void operator()(Quaternion& rotation) { transfer(rotation.coeffs().data(), 4 * sizeof(double)); }
  void operator()(Pose& pose) {
    (*this)(pose.position);
    (*this)(pose.rotation);
  }
  void operator()(std::string& text) {
    std::size_t size = text.size();
    (*this)(size);
    if (isGiving_) text.resize(std::min(size, given_.size()));
    transfer(text.data(), size);
  }

  template <class T>
  requires requires(T& value, StateArchive& archive) { value.transfer(archive); }
  void operator()(T& value) { value.transfer(*this); }
  template <class T>
  void operator()(std::optional<T>& value) {
    bool is = value.has_value();
    (*this)(is);
    if (isGiving_) is ? void(value.emplace()) : value.reset();
    if (value) (*this)(*value);
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    transferList(list);
  }
  template <class T>
  void operator()(std::deque<T>& list) {
    transferList(list);
  }

  /// @return The written bytes.
  std::vector<std::byte> take() { return std::move(taken_); }
  /// @return The bytes not read yet.
  std::span<const std::byte> rest() const { return given_; }

 private:
  template <class List>
  void transferList(List& list) {
    std::size_t size = list.size();
    (*this)(size);
    // No memory is allocated for more than can be there.
    if (isGiving_) list.resize(std::min(size, given_.size()));
    for (auto& value : list) (*this)(value);
  }

  void transfer(void* memory, std::size_t size) {
    if (isGiving_) {
      if (size > given_.size()) throw std::out_of_range("a saved state is truncated");
      std::memcpy(memory, given_.data(), size);
      given_ = given_.subspan(size);
    } else {
      const auto* bytes = static_cast<const std::byte*>(memory);
      taken_.insert(taken_.end(), bytes, bytes + size);
    }
  }

  bool isGiving_ = false;
  std::span<const std::byte> given_;
  std::vector<std::byte> taken_;
};

}  // namespace pongsim
