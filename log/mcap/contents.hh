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

/// A part of an MCAP file that is read in one go: a chunk, or records that stand in no chunk.
struct Block {
  /// In the file [B], with the head of its record.
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  bool isChunk = true;
  /// Of its messages [ns].
  std::uint64_t startTime = 0, endTime = 0;
  /// As the file has it, and bytes unpacked.
  std::string compression;
  std::uint64_t uncompressedSize = 0;
};

/// What an MCAP file has, and where.
struct Contents {
  mcap::Header header;
  std::map<std::uint16_t, mcap::Schema> schemas;
  std::map<std::uint16_t, mcap::Channel> channels;
  /// In their order in the file.
  std::vector<Block> blocks;
  /// Messages of each channel, and of all.
  std::map<std::uint16_t, std::uint64_t> counts;
  std::uint64_t count = 0;
  /// [ns]; 0 where there are no messages.
  std::uint64_t startTime = 0, endTime = 0;
  /// What is missing, where something is.
  std::optional<std::string> torn;
};

/// Of one record: what it is, and where its content stands.
struct RecordPlace {
  mcap::Opcode opcode = mcap::Opcode::kHeader;
  std::string_view content;
  /// Of the record's head, in the bytes it was read from.
  std::uint64_t offset = 0;
};

/// Takes the next record of a row of them.
/// @throws Failure where it is cut off.
RecordPlace nextRecord(ByteReader& records);

/// The records of a block, unpacked.
struct UnpackedBlock {
  std::string records;
  /// As the chunk has it.
  std::string compression;
  /// In the file [B]: of the records, or of the chunk where they are packed.
  std::uint64_t offset = 0;
};

/// @throws Failure where the block is damaged, or no chunk.
UnpackedBlock unpackBlock(const InputFile& file, const Block& block);

/// Calls `visit` with each record and a reader of its content.
/// @throws Failure, as one of `visit` does, with the place in the file where that is known.
void forEachRecord(const UnpackedBlock& block, const std::function<void(const RecordPlace&, ByteReader&)>& visit);

/// @return What the file has, by its summary, or by all of it where there is none, or one that is damaged.
/// @throws Failure where it is no MCAP file.
Contents contentsOf(const InputFile& file);

}  // namespace pongsim::log
