#include "log/mcap/summary.hh"

#include "log/mcap/compression.hh"
#include "log/mcap/record_archive.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

/// A summary that does not suffice, so the file must be scanned.
struct Insufficient {};

Block blockOf(const mcap::ChunkIndex& index, std::uint64_t end, const ByteReader& at) {
  if (index.offset > end || index.length > end - index.offset) {
    at.fail("the chunk at byte " + std::to_string(index.offset) + " can't have " + std::to_string(index.length) +
            " bytes");
  }
  return {.offset = index.offset,
          .length = index.length,
          .isChunk = true,
          .startTime = index.startTime,
          .endTime = index.endTime,
          .compression = index.compression,
          .uncompressedSize = index.uncompressedSize};
}

void check(const Contents& contents, const std::optional<mcap::Statistics>& statistics) {
  if (!statistics || statistics->chunkCount != contents.blocks.size()) throw Insufficient();
  const bool hasMessages = statistics->messageCount > 0;
  if (hasMessages && (contents.blocks.empty() || statistics->channelMessageCounts.empty())) throw Insufficient();
  for (const auto& [channel, count] : statistics->channelMessageCounts) {
    if (!contents.channels.contains(channel)) throw Insufficient();
  }
}

/// @param start Offset of the summary in the file, the end of the data.
Contents parse(std::string_view summary, std::uint64_t start) {
  Contents contents;
  std::optional<mcap::Statistics> statistics;
  ByteReader records(summary, start, "summary");
  while (!records.isAtEnd()) {
    const RecordPlace record = nextRecord(records);
    ByteReader fields(record.content, records.offset() - record.content.size(), "record of the summary");
    switch (record.opcode) {
      case mcap::Opcode::kSchema: {
        mcap::Schema schema = mcap::readRecord<mcap::Schema>(fields);
        contents.schemas[schema.id] = std::move(schema);
        break;
      }
      case mcap::Opcode::kChannel: {
        mcap::Channel channel = mcap::readRecord<mcap::Channel>(fields);
        contents.channels[channel.id] = std::move(channel);
        break;
      }
      case mcap::Opcode::kChunkIndex:
        contents.blocks.push_back(blockOf(mcap::readRecord<mcap::ChunkIndex>(fields), start, fields));
        break;
      case mcap::Opcode::kStatistics:
        statistics = mcap::readRecord<mcap::Statistics>(fields);
        break;
      default:
        break;
    }
  }
  check(contents, statistics);
  contents.counts = statistics->channelMessageCounts;
  contents.count = statistics->messageCount;
  contents.startTime = statistics->startTime;
  contents.endTime = statistics->endTime;
  return contents;
}

}  // namespace

std::optional<Contents> contentsBySummary(const InputFile& file, std::string& why) {
  const std::uint64_t tail = mcap::kFooterSize + mcap::kMagic.size();
  if (file.size() < mcap::kMagic.size() + tail) return std::nullopt;
  const std::uint64_t footerOffset = file.size() - tail;
  const std::string end = file.read(footerOffset, tail);
  if (!end.ends_with(mcap::kMagic)) return std::nullopt;
  try {
    ByteReader reader(end, footerOffset, "footer");
    const RecordPlace record = nextRecord(reader);
    if (record.opcode != mcap::Opcode::kFooter) throw Failure(atByte(footerOffset, "there is no footer here"));
    ByteReader fields(record.content, footerOffset + mcap::kRecordHead, "footer");
    const mcap::Footer footer = mcap::readRecord<mcap::Footer>(fields);
    if (footer.summaryStart == 0) return std::nullopt;
    if (footer.summaryStart > footerOffset || footer.summaryOffsetStart > footerOffset ||
        (footer.summaryOffsetStart != 0 && footer.summaryOffsetStart < footer.summaryStart)) {
      throw Failure(atByte(footerOffset, "its summary can't be at byte " + std::to_string(footer.summaryStart)));
    }
    const std::uint64_t summaryEnd = footer.summaryOffsetStart == 0 ? footerOffset : footer.summaryOffsetStart;
    const std::string summary = file.read(footer.summaryStart, file.size() - footer.summaryStart);
    const std::string_view summed =
        std::string_view(summary).substr(0, summary.size() - mcap::kMagic.size() - sizeof(footer.summaryCrc));
    if (footer.summaryCrc != 0 && crc32Of(summed) != footer.summaryCrc) {
      throw Failure(atByte(footer.summaryStart, "its checksum is wrong"));
    }
    return parse(std::string_view(summary).substr(0, summaryEnd - footer.summaryStart), footer.summaryStart);
  } catch (const Failure& failure) {
    why = failure.what();
  } catch (const Insufficient&) {
    // the format allows this
  }
  return std::nullopt;
}

}  // namespace pongsim::log
