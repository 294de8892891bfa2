#pragma once

#include <concepts>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "log/mcap/bytes.hh"
#include "log/mcap/record_types.hh"

/// Converts records from and to bytes, following their `visit`.
namespace pongsim::log::mcap {

/// Fills the fields of a record.
class RecordReader {
 public:
  /// @param from Must outlive it.
  explicit RecordReader(ByteReader& from) : from_(from) {}

  void operator()(auto&... fields) { (take(fields), ...); }
  /// Everything that is left.
  void rest(std::string_view& bytes) { bytes = from_.rest(); }
  /// Bytes preceded by their length in eight bytes.
  void block(std::string_view& bytes) { bytes = from_.raw(from_.number<std::uint64_t>()); }

 private:
  template <std::unsigned_integral Number>
  void take(Number& number) {
    number = from_.number<Number>();
  }
  void take(Opcode& opcode) { opcode = static_cast<Opcode>(from_.number<std::uint8_t>()); }
  void take(std::string& text) { text = from_.text(); }
  template <class Key, class Value>
  void take(std::map<Key, Value>& map) {
    takeEach<Key, Value>([&map](Key& key, Value& value) { map[std::move(key)] = std::move(value); });
  }
  template <class First, class Second>
  void take(std::vector<std::pair<First, Second>>& list) {
    takeEach<First, Second>(
        [&list](First& first, Second& second) { list.emplace_back(std::move(first), std::move(second)); });
  }

  /// The pairs of a list, preceded by its size in bytes.
  template <class First, class Second>
  void takeEach(const auto& add) {
    ByteReader entries = from_.part(from_.number<std::uint32_t>());
    RecordReader entry(entries);
    while (!entries.isAtEnd()) {
      First first{};
      Second second{};
      entry(first, second);
      add(first, second);
    }
  }

  ByteReader& from_;
};

/// Writes the fields of a record.
class RecordWriter {
 public:
  /// @param bytes The output is appended to it; must outlive it.
  explicit RecordWriter(std::string& bytes) : to_(bytes) {}

  void operator()(const auto&... fields) { (put(fields), ...); }
  void rest(std::string_view bytes) { to_.raw(bytes); }
  void block(std::string_view bytes) {
    to_.number(std::uint64_t{bytes.size()});
    to_.raw(bytes);
  }

 private:
  template <std::unsigned_integral Number>
  void put(Number number) {
    to_.number(number);
  }
  void put(Opcode opcode) { to_.number(static_cast<std::uint8_t>(opcode)); }
  void put(const std::string& text) { to_.text(text); }
  template <class Key, class Value>
  void put(const std::map<Key, Value>& map) {
    putEach(map);
  }
  template <class First, class Second>
  void put(const std::vector<std::pair<First, Second>>& list) {
    putEach(list);
  }
  void putEach(const auto& pairs) {
    std::string entries;
    RecordWriter entry(entries);
    for (const auto& [first, second] : pairs) entry(first, second);
    to_.text(entries);
  }

  ByteWriter to_;
};

/// @return The record; fields that a later version of the format may have added at its end are ignored.
/// @throws Failure if the content is truncated or invalid.
template <class Record>
Record readRecord(ByteReader& from) {
  Record record;
  RecordReader reader(from);
  Record::visit(record, reader);
  return record;
}

/// Appends a whole record, including its head.
template <class Record>
void appendRecord(const Record& record, std::string& to) {
  const std::size_t start = to.size();
  ByteWriter head(to);
  head.number(static_cast<std::uint8_t>(Record::kOpcode));
  head.number(std::uint64_t{0});
  RecordWriter writer(to);
  Record::visit(record, writer);
  const std::uint64_t length = to.size() - start - kRecordHead;
  for (std::size_t i = 0; i < 8; ++i) to[start + 1 + i] = static_cast<char>(length >> (8 * i) & 0xffU);
}

}  // namespace pongsim::log::mcap
