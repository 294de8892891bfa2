#include "log/mcap/mcap_file.hh"

#include <algorithm>

#include "log/mcap/record_archive.hh"

namespace pongsim::log {

McapFile::McapFile(const std::filesystem::path& path, bool overwrites, const std::string& profile,
                   Compression compression)
    : file_(path, overwrites), compression_(compression), packer_(compression) {
  std::string bytes(mcap::kMagic);
  appendRecord(mcap::Header{profile, "pongsim " PONGSIM_VERSION}, bytes);
  put(bytes);
}

void McapFile::put(std::string_view bytes) {
  file_.write(bytes);
  crc_ = crc32Of(bytes, crc_);
}

void McapFile::append(const ChunkBuilder& chunk) {
  const std::string_view packed = packer_.pack(chunk.records());
  std::string bytes;
  appendRecord(mcap::Chunk{chunk.startTime(), chunk.endTime(), chunk.records().size(), crc32Of(chunk.records()),
                           std::string(compressionName(compression_)), packed},
               bytes);
  mcap::ChunkIndex index{.startTime = chunk.startTime(),
                         .endTime = chunk.endTime(),
                         .offset = file_.size(),
                         .length = bytes.size(),
                         .messageIndexOffsets = {},
                         .messageIndexLength = 0,
                         .compression = std::string(compressionName(compression_)),
                         .compressedSize = packed.size(),
                         .uncompressedSize = chunk.records().size()};
  put(bytes);

  std::string indexes;
  for (const auto& [channel, each] : chunk.indexes()) {
    index.messageIndexOffsets[channel] = file_.size() + indexes.size();
    appendRecord(each, indexes);
  }
  index.messageIndexLength = indexes.size();
  put(indexes);
  chunks_.push_back(std::move(index));
  count(chunk);
}

void McapFile::count(const ChunkBuilder& chunk) {
  ++statistics_.chunkCount;
  if (chunk.indexes().empty()) return;
  const bool isFirst = statistics_.messageCount == 0;
  statistics_.startTime = isFirst ? chunk.startTime() : std::min(statistics_.startTime, chunk.startTime());
  statistics_.endTime = std::max(statistics_.endTime, chunk.endTime());
  for (const auto& [channel, index] : chunk.indexes()) {
    statistics_.messageCount += index.entries.size();
    statistics_.channelMessageCounts[channel] += index.entries.size();
  }
}

void McapFile::finish(const std::vector<mcap::Schema>& schemas, const std::vector<mcap::Channel>& channels) {
  statistics_.schemaCount = static_cast<std::uint16_t>(schemas.size());
  statistics_.channelCount = static_cast<std::uint32_t>(channels.size());
  std::string end;
  appendRecord(mcap::DataEnd{crc_}, end);
  put(end);

  const std::uint64_t start = file_.size();
  std::string summary, offsets;
  const auto addGroup = [&]<class Record>(const std::vector<Record>& records) {
    const std::uint64_t before = summary.size();
    for (const Record& each : records) appendRecord(each, summary);
    if (summary.size() == before) return;
    appendRecord(mcap::SummaryOffset{Record::kOpcode, start + before, summary.size() - before}, offsets);
  };
  addGroup(schemas);
  addGroup(channels);
  addGroup(std::vector{statistics_});
  addGroup(chunks_);

  const mcap::Footer footer{start, start + summary.size(), 0};
  summary += offsets;
  appendRecord(footer, summary);
  // its last field is the checksum of everything before it
  summary.resize(summary.size() - sizeof(footer.summaryCrc));
  ByteWriter writer(summary);
  writer.number(crc32Of(summary));
  writer.raw(mcap::kMagic);
  file_.write(summary);
  file_.close();
}

}  // namespace pongsim::log
