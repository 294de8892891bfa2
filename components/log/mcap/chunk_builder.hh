#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "log/mcap/record_archive.hh"
#include "log/mcap/record_types.hh"

namespace pongsim::log {

/// A chunk being filled.
class ChunkBuilder {
 public:
  void add(const mcap::Schema& schema) { appendRecord(schema, records_); }
  void add(const mcap::Channel& channel) { appendRecord(channel, records_); }
  void add(const mcap::Message& message);

  bool isEmpty() const { return records_.empty(); }
  /// Its records, uncompressed.
  const std::string& records() const { return records_; }
  /// Time range of the messages [ns]; 0 without any.
  std::uint64_t startTime() const { return startTime_; }
  std::uint64_t endTime() const { return endTime_; }
  /// One for each channel with messages, by channel id.
  const std::map<std::uint16_t, mcap::MessageIndex>& indexes() const { return indexes_; }

 private:
  std::string records_;
  std::uint64_t startTime_ = 0, endTime_ = 0;
  std::map<std::uint16_t, mcap::MessageIndex> indexes_;
};

}  // namespace pongsim::log
