#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ros2/types/bulk.hh"
#include "ros2/types/reflection.hh"

/// Plain CDR, ROS 2's wire format: four bytes that name the encoding, then the fields. Each number is aligned to its
/// own size, counted from after those four bytes (OMG DDS-XTypes 1.3, 7.4.1, encoding version 1).
///
/// Fast CDR is not used, although Fast DDS brings it: it allocates as many elements as a message claims, before it looks
/// how many bytes are left, its errors do not name a field, and it has no place for pixels that are written directly.
namespace pongsim::ros2 {

/// Size of the encoding's name.
inline constexpr std::size_t kEncapsulation = 4;

/// Counts the bytes of a value, without the encapsulation.
class CdrSize {
 public:
  void operator()(const char*, const auto& value) { add(value); }
  std::size_t size() const { return size_; }

  template <class Value>
  void add(const Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      ++size_;
    } else if constexpr (Primitive<Value>) {
      align(sizeof(Value));
      size_ += sizeof(Value);
    } else if constexpr (Text<Value>) {
      addCount();
      size_ += value.size() + 1;
    } else if constexpr (std::is_same_v<Value, BulkBytes>) {
      addCount();
      size_ += value.size;
    } else if constexpr (Structure<Value>) {
      visitFields(value, *this);
    } else {
      if constexpr (List<Value>) addCount();
      addElements(value);
    }
  }

 private:
  template <class Elements>
  void addElements(const Elements& elements) {
    using Element = typename Elements::value_type;
    if (elements.empty()) return;
    if constexpr (std::is_same_v<Element, bool>) {
      size_ += elements.size();
    } else if constexpr (Primitive<Element>) {
      align(sizeof(Element));
      size_ += elements.size() * sizeof(Element);
    } else {
      for (const Element& element : elements) add(element);
    }
  }
  void addCount() {
    align(4);
    size_ += 4;
  }
  void align(std::size_t to) { size_ = (size_ + to - 1) / to * to; }

  std::size_t size_ = 0;
};

/// @return Size of the whole payload, including the encapsulation.
template <Structure Value>
std::size_t cdrSize(const Value& value) {
  CdrSize size;
  size.add(value);
  return kEncapsulation + size.size();
}

/// Writes fields to memory that is large enough; the machine's byte order must be little endian.
class CdrWriter {
 public:
  /// @param place At least `cdrSize` bytes, including the encapsulation.
  explicit CdrWriter(std::span<std::byte> place);

  void operator()(const char*, const auto& value) { write(value); }
  /// @return Number of bytes written, including the encapsulation.
  std::size_t size() const { return kEncapsulation + at_; }

  template <class Value>
  void write(const Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      place_[at_++] = std::byte(value ? 1 : 0);
    } else if constexpr (Primitive<Value>) {
      align(sizeof(Value));
      put(&value, sizeof(Value));
    } else if constexpr (Text<Value>) {
      writeCount(value.size() + 1);
      put(value.c_str(), value.size() + 1);
    } else if constexpr (std::is_same_v<Value, BulkBytes>) {
      writeCount(value.size);
      if (value.size > 0) value.fill(place_.subspan(at_, value.size));
      at_ += value.size;
    } else if constexpr (Structure<Value>) {
      visitFields(value, *this);
    } else {
      if constexpr (List<Value>) writeCount(value.size());
      writeElements(value);
    }
  }

 private:
  template <class Elements>
  void writeElements(const Elements& elements) {
    using Element = typename Elements::value_type;
    if (elements.empty()) return;
    if constexpr (std::is_same_v<Element, bool>) {
      for (const bool element : elements) write(element);
    } else if constexpr (Primitive<Element>) {
      align(sizeof(Element));
      put(elements.data(), elements.size() * sizeof(Element));
    } else {
      for (const Element& element : elements) write(element);
    }
  }
  void writeCount(std::size_t count) { write(static_cast<std::uint32_t>(count)); }
  void put(const void* memory, std::size_t size) {
    std::memcpy(place_.data() + at_, memory, size);
    at_ += size;
  }
  void align(std::size_t to) {
    while (at_ % to != 0) place_[at_++] = std::byte(0);
  }

  /// Without the encapsulation.
  std::span<std::byte> place_;
  std::size_t at_ = 0;
};

/// Writes a value's payload to `cdrSize` bytes of memory.
template <Structure Value>
void writeCdr(const Value& value, std::span<std::byte> place) {
  CdrWriter writer(place);
  writer.write(value);
}
template <Structure Value>
std::vector<std::byte> toCdr(const Value& value) {
  std::vector<std::byte> bytes(cdrSize(value));
  writeCdr(value, bytes);
  return bytes;
}

/// @return Minimum size of a value of the type, at any alignment.
template <class Value>
std::size_t leastCdrSize() {
  if constexpr (Structure<Value>) {
    static const std::size_t least = [] {
      std::size_t sum = 0;
      Value value{};
      visitFields(value, [&sum]<class Field>(const char*, Field&) { sum += leastCdrSize<Field>(); });
      return sum;
    }();
    return least;
  } else if constexpr (kIsArray<Value>) {
    return Value().size() * leastCdrSize<typename Value::value_type>();
  } else if constexpr (Text<Value> || List<Value>) {
    return 4;
  } else {
    return sizeof(Value);
  }
}

/// Reads fields from untrusted bytes. Reading stops at the first error; later fields stay unchanged. Uses no more
/// memory than a small multiple of the input.
class CdrReader {
 public:
  /// @param payload Including the encapsulation; in either byte order and the plain encodings of both versions.
  explicit CdrReader(std::span<const std::byte> payload);

  template <class Value>
  void operator()(const char* name, Value& value) {
    if (error_) return;
    const char* outer = field_;
    field_ = name;
    read(value);
    if (!error_) field_ = outer;
  }

  /// @return The error ("field 'ranges' claims 4000000000 elements, but 12 bytes are left"), or nothing.
  const std::optional<std::string>& error() const { return error_; }

  template <class Value>
  void read(Value& value) {
    if (error_) return;
    if constexpr (std::is_same_v<Value, bool>) {
      std::uint8_t byte = 0;
      read(byte);
      // other values count as true, as in other readers
      value = byte != 0;
    } else if constexpr (Primitive<Value>) {
      readNumbers(&value, 1);
    } else if constexpr (Text<Value>) {
      readText(value, kBoundOf<Value>);
    } else if constexpr (Structure<Value>) {
      visitFields(value, *this);
    } else if constexpr (List<Value>) {
      readList(value);
    } else {
      readElements(value);
    }
  }

 private:
  template <class Value>
  void readList(Value& list) {
    std::uint32_t count = 0;
    read(count);
    if (error_ || !isCredible(count, leastCdrSize<typename Value::value_type>(), kBoundOf<Value>)) return;
    list.resize(count);
    readElements(list);
  }
  template <class Elements>
  void readElements(Elements& elements) {
    using Element = typename Elements::value_type;
    if (elements.empty()) return;
    if constexpr (std::is_same_v<Element, bool>) {
      for (auto&& each : elements) {
        bool element = false;
        read(element);
        each = element;
      }
    } else if constexpr (Primitive<Element>) {
      readNumbers(elements.data(), elements.size());
    } else {
      for (Element& element : elements) read(element);
    }
  }
  template <class Number>
  void readNumbers(Number* numbers, std::size_t count) {
    if (!take(numbers, sizeof(Number), count) || !isSwapped_ || sizeof(Number) == 1) return;
    for (std::size_t i = 0; i < count; ++i) {
      std::array<std::byte, sizeof(Number)> bytes;
      std::memcpy(bytes.data(), numbers + i, sizeof(Number));
      for (std::size_t j = 0; j < sizeof(Number) / 2; ++j) std::swap(bytes[j], bytes[sizeof(Number) - 1 - j]);
      std::memcpy(numbers + i, bytes.data(), sizeof(Number));
    }
  }

  void readText(std::string& text, std::size_t most);
  bool isCredible(std::uint32_t count, std::size_t leastSize, std::size_t most);
  bool take(void* to, std::size_t size, std::size_t count);
  void fail(const std::string& what);

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool isSwapped_ = false;
  std::size_t largestAlignment_ = 8;
  const char* field_ = nullptr;
  std::optional<std::string> error_;
};

/// Replaces `value` by the decoded payload.
/// @return What is wrong with it, or nothing.
template <Structure Value>
std::optional<std::string> readCdr(std::span<const std::byte> payload, Value& value) {
  CdrReader reader(payload);
  reader.read(value);
  return reader.error();
}

}  // namespace pongsim::ros2
