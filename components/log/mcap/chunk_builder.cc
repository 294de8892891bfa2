#include "log/mcap/chunk_builder.hh"

#include <algorithm>

namespace pongsim::log {

void ChunkBuilder::add(const mcap::Message& message) {
  startTime_ = indexes_.empty() ? message.logTime : std::min(startTime_, message.logTime);
  endTime_ = std::max(endTime_, message.logTime);
  mcap::MessageIndex& index = indexes_[message.channelId];
  index.channelId = message.channelId;
  index.entries.emplace_back(message.logTime, records_.size());
  appendRecord(message, records_);
}

}  // namespace pongsim::log
