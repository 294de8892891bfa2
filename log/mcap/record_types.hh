#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "log/mcap/bytes.hh"

/// The records of which an MCAP file is made (https://mcap.dev/spec), as plain values. Times are in ns, offsets and
/// lengths in bytes; offsets count from the start of the file unless it says otherwise. `read` throws Failure where the
/// content is cut off or lies; what a later version of the format may have added at its end is passed over.
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

/// Bytes of a record's opcode and length.
inline constexpr std::size_t kRecordHead = 9;
/// Bytes of a footer, its head too.
inline constexpr std::size_t kFooterSize = kRecordHead + 8 + 8 + 4;
/// Bytes of a message's content before its data.
inline constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;

struct Header {
  std::string profile;
  std::string library;
  static Header read(ByteReader& from);
  void write(ByteWriter& to) const;
};

struct Footer {
  /// 0 where there is no summary.
  std::uint64_t summaryStart = 0;
  std::uint64_t summaryOffsetStart = 0;
  /// 0 where there is none.
  std::uint32_t summaryCrc = 0;
  static Footer read(ByteReader& from);
  /// Without the sum, which is that of all before it, too.
  void writeBeforeCrc(ByteWriter& to) const;
};

struct Schema {
  /// Above 0.
  std::uint16_t id = 0;
  std::string name;
  /// "protobuf", "ros2msg", or "" where nothing is known but the name.
  std::string encoding;
  std::string data;
  static Schema read(ByteReader& from);
  void write(ByteWriter& to) const;
  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  /// 0 where it has none.
  std::uint16_t schemaId = 0;
  std::string topic;
  /// "protobuf", "cdr", ...
  std::string messageEncoding;
  std::map<std::string, std::string> metadata;
  static Channel read(ByteReader& from);
  void write(ByteWriter& to) const;
  bool operator==(const Channel&) const = default;
};

/// The data is not copied.
struct Message {
  std::uint16_t channelId = 0;
  std::uint32_t sequence = 0;
  std::uint64_t logTime = 0;
  std::uint64_t publishTime = 0;
  std::string_view data;
  static Message read(ByteReader& from);
  void write(ByteWriter& to) const;
};

/// The records in it are not copied.
struct Chunk {
  std::uint64_t startTime = 0;
  std::uint64_t endTime = 0;
  std::uint64_t uncompressedSize = 0;
  /// 0 where there is none.
  std::uint32_t uncompressedCrc = 0;
  std::string compression;
  std::string_view records;
  static Chunk read(ByteReader& from);
  /// All but the records, which follow.
  void writeBeforeRecords(ByteWriter& to) const;
};

/// Where the messages of a channel are in the chunk before it.
struct MessageIndex {
  std::uint16_t channelId = 0;
  /// Time, and offset in the unpacked chunk.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> entries;
  void write(ByteWriter& to) const;
};

struct ChunkIndex {
  std::uint64_t startTime = 0;
  std::uint64_t endTime = 0;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::map<std::uint16_t, std::uint64_t> messageIndexOffsets;
  std::uint64_t messageIndexLength = 0;
  std::string compression;
  std::uint64_t compressedSize = 0;
  std::uint64_t uncompressedSize = 0;
  static ChunkIndex read(ByteReader& from);
  void write(ByteWriter& to) const;
};

struct Statistics {
  std::uint64_t messageCount = 0;
  std::uint16_t schemaCount = 0;
  std::uint32_t channelCount = 0;
  std::uint32_t attachmentCount = 0;
  std::uint32_t metadataCount = 0;
  std::uint32_t chunkCount = 0;
  std::uint64_t startTime = 0;
  std::uint64_t endTime = 0;
  std::map<std::uint16_t, std::uint64_t> channelMessageCounts;
  static Statistics read(ByteReader& from);
  void write(ByteWriter& to) const;
};

struct SummaryOffset {
  Opcode group = Opcode::kSchema;
  std::uint64_t start = 0;
  std::uint64_t length = 0;
  void write(ByteWriter& to) const;
};

/// Appends a record, head and all.
template <class Record>
void appendRecord(Opcode opcode, const Record& record, std::string& to) {
  const std::size_t start = to.size();
  ByteWriter writer(to);
  writer.number(static_cast<std::uint8_t>(opcode));
  writer.number(std::uint64_t{0});
  record.write(writer);
  const std::uint64_t length = to.size() - start - kRecordHead;
  for (std::size_t i = 0; i < 8; ++i) to[start + 1 + i] = static_cast<char>(length >> (8 * i) & 0xffU);
}

}  // namespace pongsim::log::mcap
