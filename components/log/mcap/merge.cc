#include "log/mcap/merge.hh"

#include <algorithm>
#include <cassert>
#include <utility>

#include "log/mcap/record_archive.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

constexpr std::size_t kMostLoaded = std::size_t{512} << 20U;
// with a total of 2 GiB
constexpr std::size_t kMostQueued = std::size_t{1} << 26U;

}  // namespace

Merge::Merge(const InputFile& file, const std::vector<Block>& blocks, std::uint64_t from, std::uint64_t to,
             IsWanted isWanted)
    : file_(file), blocks_(blocks), isWanted_(std::move(isWanted)) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].startTime <= to && blocks[i].endTime >= from) order_.push_back(i);
  }
  std::ranges::stable_sort(order_, {}, [&blocks](std::size_t i) { return blocks[i].startTime; });
}

std::optional<mcap::Message> Merge::next() {
  if (used_) forget(*std::exchange(used_, std::nullopt));
  while (nextBlock_ < order_.size() && (queue_.empty() || blocks_[order_[nextBlock_]].startTime <= queue_.top().time)) {
    load(order_[nextBlock_++]);
  }
  if (queue_.empty()) return std::nullopt;
  const QueuedMessage first = queue_.top();
  queue_.pop();
  used_ = first.block;
  const UnpackedBlock& block = unpacked(first.block);
  ByteReader fields(std::string_view(block.records).substr(first.offset, first.length), 0, "message");
  return mcap::readRecord<mcap::Message>(fields);
}

void Merge::load(std::size_t block) {
  const std::size_t before = queue_.size();
  UnpackedBlock unpacked = unpackBlock(file_, blocks_[block]);
  forEachRecord(unpacked, [&](const RecordPlace& record, ByteReader& fields) {
    if (record.opcode != mcap::Opcode::kMessage) return;
    const mcap::Message message = mcap::readRecord<mcap::Message>(fields);
    if (!isWanted_(message.channelId, message.logTime)) return;
    queue_.push({message.logTime, block, record.offset + mcap::kRecordHead, record.content.size()});
  });
  if (queue_.size() > kMostQueued) {
    throw Failure(atByte(blocks_[block].offset, "more than " + std::to_string(kMostQueued) +
                                                    " messages overlap in time, in chunks up to this one"));
  }
  const std::size_t wanted = queue_.size() - before;
  if (wanted == 0) return;
  loadedSize_ += unpacked.records.size();
  loaded_[block] = {std::move(unpacked), wanted};
}

const UnpackedBlock& Merge::unpacked(std::size_t block) {
  Loaded& wanted = loaded_.at(block);
  for (auto& [number, each] : loaded_) {
    if (loadedSize_ <= kMostLoaded) break;
    if (number == block) continue;
    loadedSize_ -= each.unpacked.records.size();
    each.unpacked = {};
  }
  if (wanted.unpacked.records.empty()) {
    wanted.unpacked = unpackBlock(file_, blocks_[block]);
    loadedSize_ += wanted.unpacked.records.size();
  }
  return wanted.unpacked;
}

/// A message of the block has been returned.
void Merge::forget(std::size_t block) {
  const auto found = loaded_.find(block);
  assert(found != loaded_.end() && found->second.wanted > 0);
  if (--found->second.wanted > 0) return;
  loadedSize_ -= found->second.unpacked.records.size();
  loaded_.erase(found);
}

}  // namespace pongsim::log
