#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The records of an MCAP file (https://mcap.dev/spec), as plain values. Times are in ns, offsets and lengths in bytes;
/// offsets count from the start of the file unless noted otherwise. `visit` lists the fields in their order, for
/// reading and writing (record_archive.hh).
namespace pongsim::log::mcap {

inline constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);

enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

/// Size of a record's opcode and length.
inline constexpr std::size_t kRecordHead = 9;
/// Size of a footer, including its opcode and length.
inline constexpr std::size_t kFooterSize = kRecordHead + 8 + 8 + 4;

struct Header {
  static constexpr Opcode kOpcode = Opcode::kHeader;
  std::string profile;
  std::string library;
  static void visit(auto& self, auto& fields) { fields(self.profile, self.library); }
};

struct Footer {
  static constexpr Opcode kOpcode = Opcode::kFooter;
  /// 0 if there is no summary.
  std::uint64_t summaryStart = 0;
  std::uint64_t summaryOffsetStart = 0;
  /// 0 if there is none.
  std::uint32_t summaryCrc = 0;
  static void visit(auto& self, auto& fields) { fields(self.summaryStart, self.summaryOffsetStart, self.summaryCrc); }
};

struct Schema {
  static constexpr Opcode kOpcode = Opcode::kSchema;
  /// Positive.
  std::uint16_t id = 0;
  std::string name;
  /// "protobuf", "ros2msg", or "" if nothing but the name is known.
  std::string encoding;
  std::string data;
  static void visit(auto& self, auto& fields) { fields(self.id, self.name, self.encoding, self.data); }
  bool operator==(const Schema&) const = default;
};

struct Channel {
  static constexpr Opcode kOpcode = Opcode::kChannel;
  std::uint16_t id = 0;
  /// 0 if it has none.
  std::uint16_t schemaId = 0;
  std::string topic;
  /// "protobuf", "cdr", ...
  std::string messageEncoding;
  std::map<std::string, std::string> metadata;
  static void visit(auto& self, auto& fields) {
    fields(self.id, self.schemaId, self.topic, self.messageEncoding, self.metadata);
  }
  bool operator==(const Channel&) const = default;
};

/// The data is not copied.
struct Message {
  static constexpr Opcode kOpcode = Opcode::kMessage;
  std::uint16_t channelId = 0;
  std::uint32_t sequence = 0;
  std::uint64_t logTime = 0;
  std::uint64_t publishTime = 0;
  std::string_view data;
  static void visit(auto& self, auto& fields) {
    fields(self.channelId, self.sequence, self.logTime, self.publishTime);
    fields.rest(self.data);
  }
};

/// The records inside are not copied.
struct Chunk {
  static constexpr Opcode kOpcode = Opcode::kChunk;
  std::uint64_t startTime = 0;
  std::uint64_t endTime = 0;
  std::uint64_t uncompressedSize = 0;
  /// 0 if there is none.
  std::uint32_t uncompressedCrc = 0;
  std::string compression;
  std::string_view records;
  static void visit(auto& self, auto& fields) {
    fields(self.startTime, self.endTime, self.uncompressedSize, self.uncompressedCrc, self.compression);
    fields.block(self.records);
  }
};

/// Where a channel's messages are in the preceding chunk.
struct MessageIndex {
  static constexpr Opcode kOpcode = Opcode::kMessageIndex;
  std::uint16_t channelId = 0;
  /// Time, and offset in the uncompressed chunk.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> entries;
  static void visit(auto& self, auto& fields) { fields(self.channelId, self.entries); }
};

struct ChunkIndex {
  static constexpr Opcode kOpcode = Opcode::kChunkIndex;
  std::uint64_t startTime = 0;
  std::uint64_t endTime = 0;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::map<std::uint16_t, std::uint64_t> messageIndexOffsets;
  std::uint64_t messageIndexLength = 0;
  std::string compression;
  std::uint64_t compressedSize = 0;
  std::uint64_t uncompressedSize = 0;
  static void visit(auto& self, auto& fields) {
    fields(self.startTime, self.endTime, self.offset, self.length, self.messageIndexOffsets, self.messageIndexLength,
           self.compression, self.compressedSize, self.uncompressedSize);
  }
};

struct Statistics {
  static constexpr Opcode kOpcode = Opcode::kStatistics;
  std::uint64_t messageCount = 0;
  std::uint16_t schemaCount = 0;
  std::uint32_t channelCount = 0;
  std::uint32_t attachmentCount = 0;
  std::uint32_t metadataCount = 0;
  std::uint32_t chunkCount = 0;
  std::uint64_t startTime = 0;
  std::uint64_t endTime = 0;
  std::map<std::uint16_t, std::uint64_t> channelMessageCounts;
  static void visit(auto& self, auto& fields) {
    fields(self.messageCount, self.schemaCount, self.channelCount, self.attachmentCount, self.metadataCount,
           self.chunkCount, self.startTime, self.endTime, self.channelMessageCounts);
  }
};

struct SummaryOffset {
  static constexpr Opcode kOpcode = Opcode::kSummaryOffset;
  Opcode group = Opcode::kSchema;
  std::uint64_t start = 0;
  std::uint64_t length = 0;
  static void visit(auto& self, auto& fields) { fields(self.group, self.start, self.length); }
};

struct DataEnd {
  static constexpr Opcode kOpcode = Opcode::kDataEnd;
  /// Of everything before it; 0 if there is none.
  std::uint32_t crc = 0;
  static void visit(auto& self, auto& fields) { fields(self.crc); }
};

}  // namespace pongsim::log::mcap
