#include "log/mcap/contents.hh"

#include <algorithm>

#include "log/mcap/compression.hh"
#include "log/mcap/record_archive.hh"
#include "log/mcap/scan.hh"
#include "log/mcap/summary.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

mcap::Header readHeader(const InputFile& file) {
  if (file.size() < mcap::kMagic.size())
    throw Failure("it is not an MCAP file: it has " + std::to_string(file.size()) + " bytes");
  const std::string magic = file.read(0, mcap::kMagic.size());
  if (magic.substr(0, 5) != mcap::kMagic.substr(0, 5)) {
    throw Failure("it is not an MCAP file: it does not begin like one", "pongsim log reads .mcap and .tlog");
  }
  if (magic != mcap::kMagic) throw Failure(atByte(5, "it is not MCAP version 0"));
  if (file.size() < mcap::kMagic.size() + mcap::kRecordHead) return {};
  const std::string head = file.read(mcap::kMagic.size(), mcap::kRecordHead);
  ByteReader reader(head, mcap::kMagic.size(), "header");
  if (reader.number<std::uint8_t>() != static_cast<std::uint8_t>(mcap::Opcode::kHeader)) {
    throw Failure(atByte(mcap::kMagic.size(), "there is no header here"));
  }
  const std::uint64_t start = mcap::kMagic.size() + mcap::kRecordHead;
  const std::uint64_t length = reader.number<std::uint64_t>();
  // the file has only just been started
  if (length > file.size() - start) return {};
  const std::string content = file.read(start, length);
  ByteReader fields(content, start, "header");
  return mcap::readRecord<mcap::Header>(fields);
}

}  // namespace

RecordPlace nextRecord(ByteReader& records) {
  RecordPlace place;
  place.offset = records.position();
  place.opcode = static_cast<mcap::Opcode>(records.number<std::uint8_t>());
  place.content = records.raw(records.number<std::uint64_t>());
  return place;
}

UnpackedBlock unpackBlock(const InputFile& file, const Block& block) {
  std::string bytes = file.read(block.offset, block.length);
  if (!block.isChunk) return {std::move(bytes), "", block.offset};
  ByteReader reader(bytes, block.offset, "chunk");
  const RecordPlace record = nextRecord(reader);
  if (record.opcode != mcap::Opcode::kChunk) throw Failure(atByte(block.offset, "there is no chunk here"));
  ByteReader fields(record.content, block.offset + mcap::kRecordHead, "chunk");
  const mcap::Chunk chunk = mcap::readRecord<mcap::Chunk>(fields);
  const std::optional<Compression> compression = compressionOf(chunk.compression);
  if (!compression) {
    throw Failure(atByte(block.offset, "the chunk is packed by '" + chunk.compression + "', which is not supported"),
                  "supported are zstd and lz4");
  }
  try {
    std::string records = unpack(*compression, chunk.records, chunk.uncompressedSize);
    if (chunk.uncompressedCrc != 0 && crc32Of(records) != chunk.uncompressedCrc) {
      throw Failure("its checksum is wrong");
    }
    const bool isPlain = *compression == Compression::kNone;
    return {std::move(records), chunk.compression, isPlain ? fields.offset() - chunk.records.size() : block.offset};
  } catch (const Failure& failure) {
    throw Failure(atByte(block.offset, std::string("the chunk is damaged: ") + failure.what()));
  }
}

void forEachRecord(const UnpackedBlock& block, const std::function<void(const RecordPlace&, ByteReader&)>& visit) {
  const bool isPacked = !block.compression.empty();
  const std::uint64_t offset = isPacked ? 0 : block.offset;
  try {
    ByteReader records(block.records, offset, "record");
    while (!records.isAtEnd()) {
      const RecordPlace record = nextRecord(records);
      ByteReader fields(record.content, offset + record.offset + mcap::kRecordHead, "record");
      visit(record, fields);
    }
  } catch (const Failure& failure) {
    if (!isPacked) throw;
    throw Failure(atByte(block.offset, std::string("in the decompressed chunk, ") + failure.what()));
  }
}

Contents contentsOf(const InputFile& file) {
  const mcap::Header header = readHeader(file);
  std::string why;
  std::optional<Contents> contents = contentsBySummary(file, why);
  if (!contents) {
    contents = contentsByScan(file);
    if (!contents->torn && !why.empty())
      contents->torn = "its index can't be used (" + why + "); no message is missing";
  }
  contents->header = header;
  return *std::move(contents);
}

}  // namespace pongsim::log
