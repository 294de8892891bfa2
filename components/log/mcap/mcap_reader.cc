#include "log/mcap/mcap_reader.hh"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "log/mcap/merge.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

/// Rethrows the errors of `work` with the file's name in front.
template <class Work>
auto named(const std::string& name, const Work& work) {
  try {
    return work();
  } catch (const Failure& failure) {
    throw Failure("'" + name + "' can't be read: " + failure.what(), failure.hint());
  }
}

std::int64_t timeOf(std::uint64_t time) {
  return static_cast<std::int64_t>(std::min<std::uint64_t>(time, std::numeric_limits<std::int64_t>::max()));
}

std::uint64_t boundOf(std::int64_t time) { return static_cast<std::uint64_t>(std::max<std::int64_t>(time, 0)); }

}  // namespace

McapReader::McapReader(const std::filesystem::path& path)
    : name_(path.string()), file_(path), contents_(named(name_, [this] { return contentsOf(file_); })) {}

const mcap::Schema* McapReader::schemaOf(const mcap::Channel& channel) const {
  const auto found = contents_.schemas.find(channel.schemaId);
  return channel.schemaId == 0 || found == contents_.schemas.end() ? nullptr : &found->second;
}

std::string_view McapReader::typeOf(const mcap::Channel& channel) const {
  const mcap::Schema* schema = schemaOf(channel);
  return schema == nullptr ? std::string_view() : schema->name;
}

std::vector<Topic> McapReader::topics() const {
  std::map<std::pair<std::string, std::string>, std::uint64_t> counts;
  for (const auto& [id, channel] : contents_.channels) {
    const auto count = contents_.counts.find(id);
    counts[{channel.topic, std::string(typeOf(channel))}] += count == contents_.counts.end() ? 0 : count->second;
  }
  std::vector<Topic> topics;
  for (const auto& [key, count] : counts) topics.push_back({key.first, key.second, count});
  return topics;
}

std::optional<TimeRange> McapReader::timeRange() const {
  if (contents_.count == 0) return std::nullopt;
  return TimeRange{timeOf(contents_.startTime), timeOf(contents_.endTime)};
}

void McapReader::forEach(const Selection& selection, const std::function<bool(const Record&)>& visit) const {
  if (selection.to < 0) return;
  const std::uint64_t from = boundOf(selection.from), to = boundOf(selection.to);
  std::set<std::uint16_t> wanted;
  for (const auto& [id, channel] : contents_.channels) {
    if (!selection.topics || std::ranges::count(*selection.topics, channel.topic) > 0) wanted.insert(id);
  }
  Merge merge(file_, contents_.blocks, from, to, [&](std::uint16_t channel, std::uint64_t time) {
    return time >= from && time <= to && wanted.contains(channel);
  });
  while (const auto message = named(name_, [&merge] { return merge.next(); })) {
    const mcap::Channel& channel = contents_.channels.at(message->channelId);
    if (!visit(Record{timeOf(message->logTime), channel.topic, typeOf(channel), message->data})) return;
  }
}

std::optional<std::string> McapReader::torn() const {
  if (!contents_.torn) return std::nullopt;
  return "'" + name_ + "': " + *contents_.torn;
}

Definition McapReader::definition(std::string_view topic, std::string_view type) const {
  for (const auto& [id, channel] : contents_.channels) {
    if (channel.topic != topic || typeOf(channel) != type) continue;
    const mcap::Schema* schema = schemaOf(channel);
    if (schema == nullptr) return {"", "", channel.messageEncoding, channel.metadata};
    return {schema->encoding, schema->data, channel.messageEncoding, channel.metadata};
  }
  return {};
}

Packing McapReader::packing() const {
  Packing packing;
  std::set<std::string> names;
  for (const Block& block : contents_.blocks) {
    names.insert(block.compression.empty() ? "none" : block.compression);
    packing.chunks += block.isChunk ? 1 : 0;
    packing.packed += block.length;
    packing.unpacked += block.uncompressedSize;
  }
  for (const std::string& name : names) packing.compression += (packing.compression.empty() ? "" : ", ") + name;
  return packing;
}

}  // namespace pongsim::log
