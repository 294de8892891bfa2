#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "log/mcap/definition.hh"
#include "log/mcap/mcap_reader.hh"
#include "log/mcap/mcap_writer.hh"
#include "log/store/failure.hh"

namespace pongsim::log::samples {

inline Definition someDefinition(std::string_view, std::string_view type) {
  return {"protobuf", "description of " + std::string(type), "protobuf"};
}

/// A record that owns its data.
struct Kept {
  std::int64_t timeNs = 0;
  std::string topic, type, payload;
  Record record() const { return {timeNs, topic, type, payload}; }
  bool operator==(const Kept&) const = default;
};

/// A hundred records of each of two topics, with payloads of different lengths.
inline std::vector<Kept> someRecords() {
  std::vector<Kept> records;
  for (int i = 0; i < 100; ++i) {
    records.push_back({i * 1000, "/a", "some.A", std::string(static_cast<std::size_t>(i % 7) * 10, 'a')});
    records.push_back({i * 1000, "/b", "some.B", "b" + std::to_string(i)});
  }
  return records;
}

inline void writeLog(const std::filesystem::path& file, const std::vector<Kept>& records, McapOptions options = {}) {
  options.overwrites = true;
  McapWriter writer(file, options, someDefinition);
  for (const Kept& each : records) writer.write(each.record());
  writer.close();
}

inline std::vector<Kept> readLog(const McapReader& reader, const Selection& selection = {}) {
  std::vector<Kept> records;
  reader.forEach(selection, [&records](const Record& each) {
    records.push_back({each.timeNs, std::string(each.topic), std::string(each.type), std::string(each.payload)});
    return true;
  });
  return records;
}

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// @return The message of the exception thrown by reading it, or "".
inline std::string failureOf(const std::filesystem::path& file) {
  try {
    readLog(McapReader(file));
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

}  // namespace pongsim::log::samples
