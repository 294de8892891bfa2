#include "log/mcap/record_types.hh"

namespace pongsim::log::mcap {

namespace {

/// Calls `take` until the bytes of a map or list, which have their length in front, are read.
template <class Take>
void readEntries(ByteReader& from, const char* what, const Take& take) {
  const std::uint32_t size = from.number<std::uint32_t>();
  const std::uint64_t offset = from.offset();
  ByteReader inner(from.raw(size), offset, what);
  while (!inner.isAtEnd()) take(inner);
}

template <class Value>
void writeEntries(const std::map<std::uint16_t, Value>& entries, ByteWriter& to) {
  to.number(static_cast<std::uint32_t>(entries.size() * (2 + sizeof(Value))));
  for (const auto& [key, value] : entries) {
    to.number(key);
    to.number(value);
  }
}

std::map<std::uint16_t, std::uint64_t> readNumbers(ByteReader& from, const char* what) {
  std::map<std::uint16_t, std::uint64_t> numbers;
  readEntries(from, what, [&numbers](ByteReader& entry) {
    const auto key = entry.number<std::uint16_t>();
    numbers[key] = entry.number<std::uint64_t>();
  });
  return numbers;
}

}  // namespace

Header Header::read(ByteReader& from) {
  Header header;
  header.profile = from.text();
  header.library = from.text();
  return header;
}

void Header::write(ByteWriter& to) const {
  to.text(profile);
  to.text(library);
}

Footer Footer::read(ByteReader& from) {
  Footer footer;
  footer.summaryStart = from.number<std::uint64_t>();
  footer.summaryOffsetStart = from.number<std::uint64_t>();
  footer.summaryCrc = from.number<std::uint32_t>();
  return footer;
}

void Footer::writeBeforeCrc(ByteWriter& to) const {
  to.number(static_cast<std::uint8_t>(Opcode::kFooter));
  to.number(std::uint64_t{kFooterSize - kRecordHead});
  to.number(summaryStart);
  to.number(summaryOffsetStart);
}

Schema Schema::read(ByteReader& from) {
  Schema schema;
  schema.id = from.number<std::uint16_t>();
  schema.name = from.text();
  schema.encoding = from.text();
  schema.data = from.text();
  return schema;
}

void Schema::write(ByteWriter& to) const {
  to.number(id);
  to.text(name);
  to.text(encoding);
  to.text(data);
}

Channel Channel::read(ByteReader& from) {
  Channel channel;
  channel.id = from.number<std::uint16_t>();
  channel.schemaId = from.number<std::uint16_t>();
  channel.topic = from.text();
  channel.messageEncoding = from.text();
  readEntries(from, "channel's metadata", [&channel](ByteReader& entry) {
    const std::string key(entry.text());
    channel.metadata[key] = entry.text();
  });
  return channel;
}

void Channel::write(ByteWriter& to) const {
  to.number(id);
  to.number(schemaId);
  to.text(topic);
  to.text(messageEncoding);
  std::string entries;
  ByteWriter writer(entries);
  for (const auto& [key, value] : metadata) {
    writer.text(key);
    writer.text(value);
  }
  to.text(entries);
}

Message Message::read(ByteReader& from) {
  Message message;
  message.channelId = from.number<std::uint16_t>();
  message.sequence = from.number<std::uint32_t>();
  message.logTime = from.number<std::uint64_t>();
  message.publishTime = from.number<std::uint64_t>();
  message.data = from.rest();
  return message;
}

void Message::write(ByteWriter& to) const {
  to.number(channelId);
  to.number(sequence);
  to.number(logTime);
  to.number(publishTime);
  to.raw(data);
}

Chunk Chunk::read(ByteReader& from) {
  Chunk chunk;
  chunk.startTime = from.number<std::uint64_t>();
  chunk.endTime = from.number<std::uint64_t>();
  chunk.uncompressedSize = from.number<std::uint64_t>();
  chunk.uncompressedCrc = from.number<std::uint32_t>();
  chunk.compression = from.text();
  chunk.records = from.raw(from.number<std::uint64_t>());
  return chunk;
}

void Chunk::writeBeforeRecords(ByteWriter& to) const {
  to.number(startTime);
  to.number(endTime);
  to.number(uncompressedSize);
  to.number(uncompressedCrc);
  to.text(compression);
  to.number(std::uint64_t{records.size()});
}

void MessageIndex::write(ByteWriter& to) const {
  to.number(channelId);
  to.number(static_cast<std::uint32_t>(entries.size() * 16));
  for (const auto& [time, offset] : entries) {
    to.number(time);
    to.number(offset);
  }
}

ChunkIndex ChunkIndex::read(ByteReader& from) {
  ChunkIndex index;
  index.startTime = from.number<std::uint64_t>();
  index.endTime = from.number<std::uint64_t>();
  index.offset = from.number<std::uint64_t>();
  index.length = from.number<std::uint64_t>();
  index.messageIndexOffsets = readNumbers(from, "chunk index");
  index.messageIndexLength = from.number<std::uint64_t>();
  index.compression = from.text();
  index.compressedSize = from.number<std::uint64_t>();
  index.uncompressedSize = from.number<std::uint64_t>();
  return index;
}

void ChunkIndex::write(ByteWriter& to) const {
  to.number(startTime);
  to.number(endTime);
  to.number(offset);
  to.number(length);
  writeEntries(messageIndexOffsets, to);
  to.number(messageIndexLength);
  to.text(compression);
  to.number(compressedSize);
  to.number(uncompressedSize);
}

Statistics Statistics::read(ByteReader& from) {
  Statistics statistics;
  statistics.messageCount = from.number<std::uint64_t>();
  statistics.schemaCount = from.number<std::uint16_t>();
  statistics.channelCount = from.number<std::uint32_t>();
  statistics.attachmentCount = from.number<std::uint32_t>();
  statistics.metadataCount = from.number<std::uint32_t>();
  statistics.chunkCount = from.number<std::uint32_t>();
  statistics.startTime = from.number<std::uint64_t>();
  statistics.endTime = from.number<std::uint64_t>();
  statistics.channelMessageCounts = readNumbers(from, "statistics");
  return statistics;
}

void Statistics::write(ByteWriter& to) const {
  to.number(messageCount);
  to.number(schemaCount);
  to.number(channelCount);
  to.number(attachmentCount);
  to.number(metadataCount);
  to.number(chunkCount);
  to.number(startTime);
  to.number(endTime);
  writeEntries(channelMessageCounts, to);
}

void SummaryOffset::write(ByteWriter& to) const {
  to.number(static_cast<std::uint8_t>(group));
  to.number(start);
  to.number(length);
}

}  // namespace pongsim::log::mcap
