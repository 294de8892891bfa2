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

/// Takes values into bytes, or gives them back in the same order; one function of the owner does both:
///
///     void transfer(StateArchive& archive) { archive(position_); archive(pid_); }
///
/// It takes numbers, the types of `types.hh`, texts, what has such a function, and optionals and lists of all of these.
/// The bytes are those of this machine's numbers.
class StateArchive {
 public:
  /// Takes values.
  StateArchive() = default;
  /// Gives values back from `bytes`, which must outlive it.
  explicit StateArchive(std::span<const std::byte> bytes) : isGiving_(true), given_(bytes) {}

  /// @return Whether it gives values back, in place of taking them.
  bool isGiving() const { return isGiving_; }

  /// @throws std::out_of_range where it has none to give any more.
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

  /// @return The bytes of what it has taken.
  std::vector<std::byte> take() { return std::move(taken_); }
  /// @return What it has not given back yet.
  std::span<const std::byte> rest() const { return given_; }

 private:
  template <class List>
  void transferList(List& list) {
    std::size_t size = list.size();
    (*this)(size);
    // of what can't be there no memory is asked for
    if (isGiving_) list.resize(std::min(size, given_.size()));
    for (auto& value : list) (*this)(value);
  }

  void transfer(void* memory, std::size_t size) {
    if (isGiving_) {
      if (size > given_.size()) throw std::out_of_range("a saved state ends early");
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
