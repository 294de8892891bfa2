#include "web/rosbridge/cdr_json.hh"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "web/foxglove/base64.hh"

namespace pongsim::web::rosbridge {

namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

// a short text in JSON can stand for a long message
constexpr std::size_t kMostBytes = std::size_t{16} << 20;
// names the encoding: little-endian plain CDR
constexpr std::string_view kEncapsulation("\0\1\0\0", 4);

/// Calls `act` with a value of the kind's type in C++. Not for texts and messages.
template <class Act>
auto withNumber(Kind kind, const Act& act) {
  switch (kind) {
    case Kind::kInt8:
      return act(std::int8_t{});
    case Kind::kInt16:
      return act(std::int16_t{});
    case Kind::kUint16:
      return act(std::uint16_t{});
    case Kind::kInt32:
      return act(std::int32_t{});
    case Kind::kUint32:
      return act(std::uint32_t{});
    case Kind::kInt64:
      return act(std::int64_t{});
    case Kind::kUint64:
      return act(std::uint64_t{});
    case Kind::kFloat32:
      return act(float{});
    case Kind::kFloat64:
      return act(double{});
    default:
      return act(std::uint8_t{});
  }
}

std::size_t sizeOf(Kind kind) {
  return withNumber(kind, [](auto number) { return sizeof(number); });
}

/// @return The tag of a typed array in CBOR (RFC 8746, table 1), little-endian; nothing for numbers of 64 bits, which
/// clients in JavaScript do not take.
std::optional<std::uint64_t> tagOf(Kind kind) {
  switch (kind) {
    case Kind::kUint8:
      return 64;
    case Kind::kUint16:
      return 69;
    case Kind::kUint32:
      return 70;
    case Kind::kInt8:
      return 72;
    case Kind::kInt16:
      return 77;
    case Kind::kInt32:
      return 78;
    case Kind::kFloat32:
      return 85;
    case Kind::kFloat64:
      return 86;
    default:
      return std::nullopt;
  }
}

class CdrReader {
 public:
  CdrReader(const RosDefinition& definition, std::span<const std::byte> payload, Form form)
      : definition_(definition),
        bytes_(payload.subspan(std::min(payload.size(), kEncapsulation.size()))),
        form_(form) {}

  json message(std::size_t type) {
    json object = json::object();
    // an empty type has one byte
    if (definition_.types[type].empty()) take(1, 1);
    for (const RosField& field : definition_.types[type]) {
      object[field.name] = value(field);
      if (isShort_) break;
    }
    return object;
  }

  bool isShort() const { return isShort_; }

 private:
  json value(const RosField& field) {
    if (field.count == Count::kOne) return one(field);
    const std::size_t count = field.count == Count::kArray ? field.size : number<std::uint32_t>();
    if (field.kind != Kind::kString && field.kind != Kind::kMessage && field.kind != Kind::kBool) {
      return numbers(field.kind, count);
    }
    json list = json::array();
    for (std::size_t i = 0; i < count && !isShort_; ++i) list.push_back(one(field));
    return list;
  }

  json one(const RosField& field) {
    if (field.kind == Kind::kMessage) return message(field.type);
    if (field.kind == Kind::kBool) return number<std::uint8_t>() != 0;
    if (field.kind != Kind::kString)
      return withNumber(field.kind, [&](auto zero) { return json(number<decltype(zero)>()); });
    // with a zero at its end
    const std::string_view text = take(number<std::uint32_t>(), 1);
    return std::string(text.substr(0, text.empty() ? 0 : text.size() - 1));
  }

  json numbers(Kind kind, std::size_t count) {
    const std::size_t size = sizeOf(kind);
    if (count == 0) return form_ == Form::kJson && kind == Kind::kUint8 ? json("") : json::array();
    if (count > bytes_.size() / size) {
      isShort_ = true;
      return {};
    }
    const std::string_view bytes = take(count * size, size);
    if (form_ == Form::kJson && kind == Kind::kUint8) return foxglove::base64(bytes);
    if (const auto tag = tagOf(kind); form_ == Form::kCbor && tag) {
      return json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), *tag);
    }
    json list = json::array();
    withNumber(kind, [&](auto zero) {
      for (std::size_t i = 0; i + size <= bytes.size(); i += size) {
        std::memcpy(&zero, bytes.data() + i, size);
        list.push_back(zero);
      }
    });
    return list;
  }

  template <class Number>
  Number number() {
    Number value{};
    const std::string_view bytes = take(sizeof(Number), sizeof(Number));
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof(Number));
    return value;
  }

  /// @return The next bytes; none if there are fewer.
  std::string_view take(std::size_t size, std::size_t alignment) {
    const std::size_t begin = (at_ + alignment - 1) / alignment * alignment;
    if (isShort_ || begin > bytes_.size() || size > bytes_.size() - begin) {
      isShort_ = true;
      return {};
    }
    at_ = begin + size;
    return {reinterpret_cast<const char*>(bytes_.data()) + begin, size};
  }

  const RosDefinition& definition_;
  const std::span<const std::byte> bytes_;
  const Form form_;
  std::size_t at_ = 0;
  bool isShort_ = false;
};

/// @return The bytes of a text in base64; nothing if it is none.
std::optional<std::string> fromBase64(std::string_view text) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char letter : text) {
    const std::size_t value = kLetters.find(letter);
    if (value == std::string_view::npos) return std::nullopt;
    bits = (bits << 6U) | static_cast<unsigned>(value);
    count += 6;
    if (count >= 8) bytes += static_cast<char>((bits >> static_cast<unsigned>(count -= 8)) & 0xFFU);
  }
  return bytes;
}

class CdrWriter {
 public:
  explicit CdrWriter(const RosDefinition& definition) : definition_(definition) {}

  void message(std::size_t type, const json& object, const std::string& path) {
    if (!object.is_object() && !object.is_null()) return fail(path, "is not an object");
    const std::vector<RosField>& fields = definition_.types[type];
    for (const auto& [name, value] : object.items()) {
      if (std::ranges::find(fields, name, &RosField::name) == fields.end())
        fail(path + name, "is no field of the type");
    }
    if (fields.empty()) bytes_ += '\0';
    for (const RosField& field : fields) {
      const auto found = object.find(field.name);
      value(field, found == object.end() ? json() : *found, path + field.name);
    }
  }

  Outcome<std::string> done() && {
    if (!fault_.empty()) return {std::nullopt, fault_};
    return {std::move(bytes_), {}};
  }

 private:
  void value(const RosField& field, const json& given, const std::string& path) {
    if (!fault_.empty()) return;
    if (field.count == Count::kOne) return one(field, given, path);
    json list = given.is_null() ? json::array() : given;
    if (field.kind == Kind::kUint8 && given.is_string()) {
      const auto bytes = fromBase64(given.get_ref<const std::string&>());
      if (!bytes) return fail(path, "is not in base64");
      list = json::array();
      for (const char byte : *bytes) list.push_back(static_cast<std::uint8_t>(byte));
    }
    if (!list.is_array()) return fail(path, "is not a list");
    if (field.count == Count::kList) put(static_cast<std::uint32_t>(list.size()));
    // an array that is left out
    const std::size_t size = field.count == Count::kArray ? field.size : list.size();
    if (!given.is_null() && list.size() != size)
      return fail(path, "does not have " + std::to_string(size) + " entries");
    for (std::size_t i = 0; i < size && fault_.empty(); ++i) {
      if (bytes_.size() > kMostBytes) return fail(path, "makes the message too long");
      one(field, i < list.size() ? list[i] : json(), path + "[" + std::to_string(i) + "]");
    }
  }

  void one(const RosField& field, const json& given, const std::string& path) {
    if (field.kind == Kind::kMessage) return message(field.type, given, path + ".");
    if (field.kind == Kind::kString) {
      if (!given.is_string() && !given.is_null()) return fail(path, "is not a text");
      const std::string text = given.is_null() ? std::string() : given.get<std::string>();
      put(static_cast<std::uint32_t>(text.size() + 1));
      bytes_ += text;
      bytes_ += '\0';
      return;
    }
    if (field.kind == Kind::kBool) {
      if (!given.is_boolean() && !given.is_null()) return fail(path, "is not true or false");
      return put(static_cast<std::uint8_t>(given.is_boolean() && given.get<bool>()));
    }
    withNumber(field.kind, [&](auto zero) { number(zero, given, path); });
  }

  template <class Number>
  void number(Number zero, const json& given, const std::string& path) {
    if (given.is_null()) return put(zero);
    if (!given.is_number()) return fail(path, "is not a number");
    if constexpr (std::is_floating_point_v<Number>) {
      put(static_cast<Number>(given.get<double>()));
    } else {
      const bool fits = given.is_number_unsigned()  ? std::in_range<Number>(given.get<std::uint64_t>())
                        : given.is_number_integer() ? std::in_range<Number>(given.get<std::int64_t>())
                                                    : isWhole<Number>(given.get<double>());
      if (!fits) return fail(path, "does not fit its type");
      put(given.get<Number>());
    }
  }

  /// Whether the number has no fraction and is in the type's range; up to 2^53, beyond which it would be rounded.
  template <class Number>
  static bool isWhole(double number) {
    constexpr double kExact = 9007199254740992.0;
    return number == std::floor(number) && std::abs(number) <= kExact &&
           std::in_range<Number>(static_cast<std::int64_t>(number));
  }

  template <class Number>
  void put(Number value) {
    const std::size_t used = bytes_.size() - kEncapsulation.size();
    bytes_.append((used + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number) - used, '\0');
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(Number));
  }

  void fail(const std::string& path, const std::string& what) {
    const std::string where = path.ends_with('.') ? path.substr(0, path.size() - 1) : path;
    if (fault_.empty()) fault_ = (where.empty() ? "the message" : where) + " " + what;
  }

  const RosDefinition& definition_;
  std::string bytes_{kEncapsulation};
  std::string fault_;
};

}  // namespace

json readCdr(const RosDefinition& definition, std::span<const std::byte> payload, Form form) {
  CdrReader reader(definition, payload, form);
  json message = reader.message(0);
  return reader.isShort() ? json() : message;
}

Outcome<std::string> writeCdr(const RosDefinition& definition, const json& message) {
  CdrWriter writer(definition);
  writer.message(0, message, "");
  return std::move(writer).done();
}

}  // namespace pongsim::web::rosbridge
