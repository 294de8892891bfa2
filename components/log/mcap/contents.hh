#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "log/mcap/bytes.hh"
#include "log/mcap/input_file.hh"
#include "log/mcap/record_types.hh"

namespace pongsim::log {

/// A part of an MCAP file that is read at once: a chunk, or records outside of chunks.
struct Block {
  /// Offset in the file, of the record's head [B].
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  bool isChunk = true;
  /// Time range of its messages [ns].
  std::uint64_t startTime = 0, endTime = 0;
  /// As given in the file, and the uncompressed size.
  std::string compression;
  std::uint64_t uncompressedSize = 0;
};

/// What an MCAP file contains, and where.
struct Contents {
  mcap::Header header;
  std::map<std::uint16_t, mcap::Schema> schemas;
  std::map<std::uint16_t, mcap::Channel> channels;
  /// In the order of the file.
  std::vector<Block> blocks;
  /// Number of messages of each channel, and in total.
  std::map<std::uint16_t, std::uint64_t> counts;
  std::uint64_t count = 0;
  /// [ns]; 0 if there are no messages.
  std::uint64_t startTime = 0, endTime = 0;
  /// What is missing, if anything.
  std::optional<std::string> torn;
};

/// A record's opcode and the position of its content.
struct RecordPlace {
  mcap::Opcode opcode = mcap::Opcode::kHeader;
  std::string_view content;
  /// Offset of the record's head, in the bytes that it was read from.
  std::uint64_t offset = 0;
};

/// Reads the next of several consecutive records.
/// @throws Failure if it is truncated.
RecordPlace nextRecord(ByteReader& records);

/// The records of a block, uncompressed.
struct UnpackedBlock {
  std::string records;
  /// As given in the chunk.
  std::string compression;
  /// Offset in the file [B]: of the records, or of the chunk if they are compressed.
  std::uint64_t offset = 0;
};

/// @throws Failure if the block is damaged, or not a chunk.
UnpackedBlock unpackBlock(const InputFile& file, const Block& block);

/// Calls `visit` with each record and a reader of its content.
/// @throws Failure like `visit`, with the position in the file if known.
void forEachRecord(const UnpackedBlock& block, const std::function<void(const RecordPlace&, ByteReader&)>& visit);

/// @return The file's contents, from its summary, or by scanning the file if the summary is missing or damaged.
/// @throws Failure if it is not an MCAP file.
Contents contentsOf(const InputFile& file);

}  // namespace pongsim::log
