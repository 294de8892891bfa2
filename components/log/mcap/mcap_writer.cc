#include "log/mcap/mcap_writer.hh"

#include <cassert>
#include <limits>
#include <utility>

#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

template <class List>
std::uint16_t nextId(const List& list, const char* what) {
  if (list.size() >= std::numeric_limits<std::uint16_t>::max()) {
    throw Failure(std::string("an MCAP file has at most 65535 ") + what);
  }
  return static_cast<std::uint16_t>(list.size() + 1);
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path, McapOptions options, Definitions definitions)
    : options_(std::move(options)),
      definitions_(std::move(definitions)),
      file_(path, options_.overwrites, options_.profile, options_.compression),
      thread_([this] { workSafely(); }) {}

McapWriter::~McapWriter() {
  try {
    close();
  } catch (const std::exception&) {
    // errors are reported by close
  }
}

void McapWriter::write(const Record& record) {
  if (record.timeNs < 0) {
    throw Failure("a message of '" + std::string(record.topic) + "' was recorded at " + std::to_string(record.timeNs) +
                  " ns, but MCAP has no times before 0");
  }
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ != nullptr || waitingSize_ < options_.queueSize; });
  if (failure_ != nullptr) std::rethrow_exception(failure_);
  if (isClosing_) throw Failure("the file is closed");
  const bool isFirst = open_.isEmpty();
  const mcap::Channel& channel = channelFor(record);
  // ids count from 1
  assert(channel.id >= 1 && channel.id <= sequences_.size());
  const auto time = static_cast<std::uint64_t>(record.timeNs);
  open_.add(mcap::Message{channel.id, sequences_[channel.id - 1U]++, time, time, record.payload});
  if (isFirst) openSince_ = Clock::now();
  if (open_.records().size() >= options_.chunkSize) endChunk();
  if (isFirst || open_.isEmpty()) changed_.notify_all();
}

/// The caller holds the mutex, here and in the functions called from here.
mcap::Channel& McapWriter::channelFor(const Record& record) {
  const auto found = channelIds_.find(std::tie(record.topic, record.type));
  if (found != channelIds_.end()) return channels_[found->second - 1U];
  mcap::Channel channel;
  const Definition definition = definitions_(record.topic, record.type);
  channel.id = nextId(channels_, "topics");
  channel.schemaId = schemaFor(record.type, definition);
  channel.topic = record.topic;
  channel.messageEncoding = definition.messageEncoding;
  channel.metadata = definition.metadata;
  open_.add(channel);
  sequences_.push_back(0);
  channelIds_.emplace(std::tie(record.topic, record.type), channel.id);
  return channels_.emplace_back(std::move(channel));
}

std::uint16_t McapWriter::schemaFor(std::string_view type, const Definition& definition) {
  if (type.empty()) return 0;
  mcap::Schema schema{0, std::string(type), definition.schemaEncoding, definition.schema};
  for (const mcap::Schema& each : schemas_) {
    schema.id = each.id;
    if (each == schema) return each.id;
  }
  schema.id = nextId(schemas_, "types");
  open_.add(schema);
  return schemas_.emplace_back(std::move(schema)).id;
}

/// The caller holds the mutex.
void McapWriter::endChunk() {
  if (open_.isEmpty()) return;
  waitingSize_ += open_.records().size();
  waiting_.push_back(std::exchange(open_, {}));
}

/// @return The next chunk to write, once there is one; nothing at the end.
std::optional<ChunkBuilder> McapWriter::nextChunk() {
  std::unique_lock lock(mutex_);
  while (waiting_.empty()) {
    if (isClosing_) {
      endChunk();
      if (waiting_.empty()) return std::nullopt;
    } else if (open_.isEmpty()) {
      changed_.wait(lock);
    } else if (Clock::now() >= openSince_ + options_.chunkAge) {
      endChunk();
    } else {
      changed_.wait_until(lock, openSince_ + options_.chunkAge);
    }
  }
  std::optional<ChunkBuilder> next(std::move(waiting_.front()));
  waiting_.pop_front();
  return next;
}

void McapWriter::work() {
  while (const std::optional<ChunkBuilder> chunk = nextChunk()) {
    file_.append(*chunk);
    const std::lock_guard lock(mutex_);
    waitingSize_ -= chunk->records().size();
    changed_.notify_all();
  }
  // both are complete now
  file_.finish(schemas_, channels_);
}

void McapWriter::workSafely() {
  try {
    work();
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
    changed_.notify_all();
  }
}

void McapWriter::close() {
  {
    const std::lock_guard lock(mutex_);
    isClosing_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
  if (failure_ != nullptr) std::rethrow_exception(failure_);
}

}  // namespace pongsim::log
