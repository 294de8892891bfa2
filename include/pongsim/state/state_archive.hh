#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
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
/// It handles numbers, enumerations, the types of `types.hh`, strings, types with such a function, and optionals and
/// lists of all these. The bytes depend on this machine's number format.
///
/// The bytes may be anybody's. What is read is what could have been written: floating-point numbers are finite and at
/// most `kLargestNumber`, times are within 73 years before and 146 years after zero, rotations are unit quaternions.
/// What else must hold, such as an index being within its list, the owner demands with `check`. A state that is refused
/// changes nothing: what has been read of it is overwritten with what was there before.
class StateArchive {
 public:
  /// Its square does not overflow.
  static constexpr double kLargestNumber = 1e150;
  /// Differences of times from the first to the last do not overflow, nor do sums with some steps.
  static constexpr Time kFirstTime{-(std::int64_t{1} << 61)};
  static constexpr Time kLastTime{std::int64_t{1} << 62};

  /// Writes values.
  StateArchive() = default;
  /// Reads values from `bytes`, which must outlive it.
  explicit StateArchive(std::span<const std::byte> bytes) : isGiving_(true), given_(bytes) {}

  /// @return Whether it reads instead of writing.
  bool isGiving() const { return isGiving_; }

  /// While reading, refuses the state unless something holds that later use of the values relies on:
  ///
  ///     archive(next_);
  ///     archive.check(next_ < points_.size());
  ///
  /// @throws std::out_of_range
  void check(bool holds) const {
    if (isGiving_ && !holds) throw std::out_of_range("it has a value out of range");
  }

  /// @throws std::out_of_range if there are no more bytes to read, or a value is none that is ever written. So do all
  /// that follow.
  template <class T>
    requires(std::is_arithmetic_v<T>)
  void operator()(T& value) {
    transfer(&value, sizeof value);
    if constexpr (std::is_floating_point_v<T>) check(isSound(value));
  }
  void operator()(bool& value) {
    // one that is to be read may not have been set
    std::uint8_t byte = !isGiving_ && value ? 1 : 0;
    (*this)(byte);
    check(byte <= 1);
    value = byte != 0;
  }
  /// @param last The enumeration's last value; the first is 0.
  template <class T>
    requires(std::is_enum_v<T>)
  void operator()(T& value, T last) {
    auto number = static_cast<std::underlying_type_t<T>>(value);
    (*this)(number);
    check(number >= 0 && number <= static_cast<std::underlying_type_t<T>>(last));
    value = static_cast<T>(number);
  }
  void operator()(Time& time) {
    Time::rep count = time.count();
    (*this)(count);
    check(count >= kFirstTime.count() && count <= kLastTime.count());
    time = Time(count);
  }
  void operator()(Vector3& vector) {
    for (double& component : vector) (*this)(component);
  }
  void operator()(Quaternion& rotation) {
    for (double& component : rotation.coeffs()) (*this)(component);
    // rounding leaves far less
    check(std::abs(rotation.squaredNorm() - 1) < 1e-6);
  }
  void operator()(Pose& pose) {
    (*this)(pose.position);
    (*this)(pose.rotation);
  }
  void operator()(std::string& text) {
    const std::size_t size = sizeOf(text.size());
    if (isGiving_) text.resize(size);
    transfer(text.data(), size);
  }

  template <class T>
    requires requires(T& value, StateArchive& archive) { value.transfer(archive); }
  void operator()(T& value) {
    value.transfer(*this);
  }
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
    const std::size_t size = sizeOf(list.size());
    if (isGiving_) list.resize(size);
    for (auto& value : list) (*this)(value);
  }

  /// @return The size that is read, or `own`. No memory is allocated for more than can be there: each element takes a
  /// byte at least.
  std::size_t sizeOf(std::size_t own) {
    std::uint64_t size = own;
    (*this)(size);
    if (isGiving_ && size > given_.size()) throw std::out_of_range("it is truncated");
    return static_cast<std::size_t>(size);
  }

  static bool isSound(double number) { return std::abs(number) <= kLargestNumber; }

  void transfer(void* memory, std::size_t size) {
    if (isGiving_) {
      if (size > given_.size()) throw std::out_of_range("it is truncated");
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
