#include "log/mcap/scan.hh"

#include <algorithm>

#include "log/mcap/record_archive.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

using mcap::Opcode;

/// Maximum size of a block of records outside of chunks.
constexpr std::uint64_t kBlockSize = std::uint64_t{4} << 20U;

/// A record's opcode and length.
struct Head {
  std::uint8_t opcode = 0;
  std::uint64_t length = 0;
};

/// Contents of one block.
struct Found {
  std::vector<mcap::Schema> schemas;
  std::vector<mcap::Channel> channels;
  std::map<std::uint16_t, std::uint64_t> counts;
  std::uint64_t count = 0, startTime = 0, endTime = 0;
};

class Scan {
 public:
  explicit Scan(const InputFile& file) : file_(file) {}

  Contents run() {
    try {
      while (next()) {
      }
    } catch (const Failure& failure) {
      contents_.torn = std::string(failure.what()) + "; the rest is ignored";
    }
    return std::move(contents_);
  }

 private:
  /// @return Whether there is more to read.
  bool next() {
    const std::uint64_t left = file_.size() - at_;
    if (left < mcap::kRecordHead) return cutOff("a record");
    const Head head = headAt(at_);
    if (head.opcode == 0) throw Failure(atByte(at_, "no record begins here"));
    const bool isChunk = head.opcode == static_cast<std::uint8_t>(Opcode::kChunk);
    if (head.length > left - mcap::kRecordHead) return cutOff(isChunk ? "a chunk" : "a record");
    const std::uint64_t size = mcap::kRecordHead + head.length;
    switch (static_cast<Opcode>(head.opcode)) {
      case Opcode::kChunk:
        addBlock(blockAt(size, true));
        break;
      case Opcode::kSchema:
      case Opcode::kChannel:
      case Opcode::kMessage:
        addLoose(size);
        break;
      case Opcode::kDataEnd:
      case Opcode::kFooter:
        return false;
      default:
        break;
    }
    at_ += size;
    return true;
  }

  bool cutOff(const std::string& what) {
    contents_.torn = atByte(at_, "it is truncated: " + what + " that begins here is incomplete");
    if (at_ == file_.size()) contents_.torn = atByte(at_, "it is truncated: it has no footer");
    return false;
  }

  Block blockAt(std::uint64_t size, bool isChunk) const {
    Block block;
    block.offset = at_;
    block.length = size;
    block.isChunk = isChunk;
    return block;
  }

  Head headAt(std::uint64_t offset) const {
    const std::string bytes = file_.read(offset, mcap::kRecordHead);
    ByteReader reader(bytes, offset, "record");
    Head head;
    head.opcode = reader.number<std::uint8_t>();
    head.length = reader.number<std::uint64_t>();
    return head;
  }

  /// Adds a record outside of chunks, to the preceding block if it directly follows that.
  void addLoose(std::uint64_t size) {
    std::vector<Block>& blocks = contents_.blocks;
    Block loose = blockAt(size, false);
    if (blocks.empty() || blocks.back().isChunk || blocks.back().offset + blocks.back().length != at_ ||
        blocks.back().length + size > kBlockSize) {
      addBlock(loose);
      return;
    }
    readBlock(loose);
    Block& last = blocks.back();
    last.length += size;
    last.uncompressedSize += size;
    last.startTime = std::min(last.startTime, loose.startTime);
    last.endTime = std::max(last.endTime, loose.endTime);
  }

  void addBlock(Block block) {
    readBlock(block);
    contents_.blocks.push_back(std::move(block));
  }

  /// Adds the block's contents, or nothing if it is damaged.
  void readBlock(Block& block) {
    const UnpackedBlock unpacked = unpackBlock(file_, block);
    Found found;
    forEachRecord(unpacked, [&](const RecordPlace& record, ByteReader& fields) { take(record, fields, found); });
    block.uncompressedSize = unpacked.records.size();
    block.compression = unpacked.compression;
    block.startTime = found.startTime;
    block.endTime = found.endTime;
    add(found);
  }

  void take(const RecordPlace& record, ByteReader& fields, Found& found) const {
    if (record.opcode == Opcode::kSchema) {
      found.schemas.push_back(mcap::readRecord<mcap::Schema>(fields));
    } else if (record.opcode == Opcode::kChannel) {
      found.channels.push_back(mcap::readRecord<mcap::Channel>(fields));
    } else if (record.opcode == Opcode::kMessage) {
      const mcap::Message message = mcap::readRecord<mcap::Message>(fields);
      if (!contents_.channels.contains(message.channelId) &&
          std::ranges::find(found.channels, message.channelId, &mcap::Channel::id) == found.channels.end()) {
        fields.fail("a message of channel " + std::to_string(message.channelId) + ", which does not exist");
      }
      found.startTime = found.count == 0 ? message.logTime : std::min(found.startTime, message.logTime);
      found.endTime = std::max(found.endTime, message.logTime);
      ++found.count;
      ++found.counts[message.channelId];
    }
  }

  void add(Found& found) {
    for (mcap::Schema& each : found.schemas) contents_.schemas[each.id] = std::move(each);
    for (mcap::Channel& each : found.channels) contents_.channels[each.id] = std::move(each);
    if (found.count == 0) return;
    contents_.startTime = contents_.count == 0 ? found.startTime : std::min(contents_.startTime, found.startTime);
    contents_.endTime = std::max(contents_.endTime, found.endTime);
    contents_.count += found.count;
    for (const auto& [channel, count] : found.counts) contents_.counts[channel] += count;
  }

  const InputFile& file_;
  Contents contents_;
  std::uint64_t at_ = mcap::kMagic.size();
};

}  // namespace

Contents contentsByScan(const InputFile& file) { return Scan(file).run(); }

}  // namespace pongsim::log
