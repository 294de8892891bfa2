#include "log/tlog/tlog_writer.hh"

#include <sqlite3.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

#include "log/store/failure.hh"
#include "log/tlog/database.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kTransactionTime{500};
/// A transaction also ends after this many bytes: a run as fast as possible writes tens of megabytes in half a second,
/// and all of a transaction is lost when the disk gets full.
constexpr std::size_t kTransactionBytes = std::size_t{1} << 20U;
/// What a message takes beside its payload, roughly.
constexpr std::size_t kRowBytes = 32;
constexpr std::size_t kMostWaitingBytes = std::size_t{64} << 20U;

// As in ignition-transport 11; its readers check the version.
constexpr const char* kSchema = R"(
BEGIN;
CREATE TABLE migrations (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  from_version TEXT DEFAULT NULL,
  to_version TEXT NOT NULL,
  time_utc INTEGER NOT NULL DEFAULT CURRENT_TIMESTAMP);
CREATE TABLE message_types (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  name TEXT NOT NULL,
  proto_descriptor TEXT);
CREATE TABLE topics (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  name TEXT NOT NULL,
  message_type_id NOT NULL REFERENCES message_types (id) ON DELETE CASCADE);
CREATE UNIQUE INDEX idx_topic ON topics (name, message_type_id);
CREATE TABLE messages (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  time_recv INTEGER NOT NULL,
  topic_id REFERENCES topics (id) ON DELETE CASCADE,
  message BLOB NOT NULL);
CREATE INDEX idx_time_recv ON messages (time_recv);
INSERT INTO migrations (to_version) VALUES ('0.1.0');
COMMIT;
)";

/// The tables of the file.
class Tables {
 public:
  explicit Tables(const fs::path& file) : database_(file.string(), file, Database::Access::kCreate) {
    // allows readers meanwhile; a committed transaction survives the end of the process
    database_.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL;");
    database_.run(kSchema);
    insertType_.emplace(database_, "INSERT INTO message_types (name) VALUES (?1)");
    insertTopic_.emplace(database_, "INSERT INTO topics (name, message_type_id) VALUES (?1, ?2)");
    insertMessage_.emplace(database_, "INSERT INTO messages (time_recv, topic_id, message) VALUES (?1, ?2, ?3)");
  }

  void begin() { database_.run("BEGIN"); }
  void commit() { database_.run("COMMIT"); }

  std::int64_t addTopic(const std::string& name, const std::string& type) {
    auto known = types_.find(type);
    if (known == types_.end()) {
      insertType_->bindText(1, type);
      known = types_.emplace(type, insert(*insertType_)).first;
    }
    insertTopic_->bindText(1, name);
    insertTopic_->bind(2, known->second);
    return insert(*insertTopic_);
  }

  void addMessage(std::int64_t time, std::int64_t topic, std::string_view payload) {
    insertMessage_->bind(1, time);
    insertMessage_->bind(2, topic);
    insertMessage_->bindBytes(3, payload);
    insert(*insertMessage_);
  }

  /// Merges the write-ahead log, so that one file has everything, as with Fortress.
  void end() {
    insertType_.reset();
    insertTopic_.reset();
    insertMessage_.reset();
    // while a reader holds it open there remain two files, which work as well
    sqlite3_busy_timeout(database_.handle(), 0);
    sqlite3_exec(database_.handle(), "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
  }

 private:
  std::int64_t insert(Statement& statement) {
    statement.step();
    statement.reset();
    return sqlite3_last_insert_rowid(database_.handle());
  }

  Database database_;
  std::map<std::string, std::int64_t> types_;
  std::optional<Statement> insertType_, insertTopic_, insertMessage_;
};

/// Queued records, with their bytes concatenated.
struct Batch {
  struct Row {
    std::int64_t timeNs;
    std::size_t topic;
    std::size_t begin;
    std::size_t size;
  };
  std::vector<Row> rows;
  std::string bytes;
  /// New topics: name and type.
  std::vector<std::pair<std::string, std::string>> topics;

  void clear() {
    rows.clear();
    bytes.clear();
    topics.clear();
  }
};

}  // namespace

struct TlogWriter::Parts {
  explicit Parts(const fs::path& file) : tables(file) {}

  void work() {
    Batch batch;
    try {
      while (take(batch)) write(batch);
      tables.end();
    } catch (const Failure& why) {
      const std::lock_guard lock(mutex);
      failure.emplace(std::string(why.what()) + "; " + std::to_string(kept) + " messages are kept", why.hint());
      waiting.clear();
    }
    taken.notify_all();
  }

  /// Waits for the next transaction, and takes all queued records.
  /// @return False at the end.
  bool take(Batch& batch) {
    batch.clear();
    std::unique_lock lock(mutex);
    given.wait_for(lock, kTransactionTime,
                   [this] { return isClosing || waiting.bytes.size() >= kMostWaitingBytes / 2; });
    std::swap(batch, waiting);
    taken.notify_all();
    return !isClosing || !batch.rows.empty();
  }

  void write(const Batch& batch) {
    if (batch.rows.empty()) return;
    tables.begin();
    for (const auto& [name, type] : batch.topics) topicIds.push_back(tables.addTopic(name, type));
    std::size_t written = 0, bytes = 0;
    const auto commit = [&] {
      tables.commit();
      kept += std::exchange(written, 0);
      bytes = 0;
    };
    for (const Batch::Row& row : batch.rows) {
      if (bytes >= kTransactionBytes) {
        commit();
        tables.begin();
      }
      tables.addMessage(row.timeNs, topicIds[row.topic], std::string_view(batch.bytes).substr(row.begin, row.size));
      ++written;
      bytes += row.size + kRowBytes;
    }
    commit();
  }

  Tables tables;
  /// Messages in completed transactions; used by the thread only, like the next one.
  std::uint64_t kept = 0;
  /// Indexed by topic number.
  std::vector<std::int64_t> topicIds;

  std::mutex mutex;
  std::condition_variable given, taken;
  Batch waiting;
  /// Numbers of the topics, keyed by name and type with a newline between them.
  std::unordered_map<std::string, std::size_t> numbers;
  std::string numbersKey;
  bool isClosing = false;
  std::optional<Failure> failure;
  std::thread thread;
};

namespace {

/// Removes an existing log, so that a new one can be created.
void removeOld(const fs::path& file) {
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
    std::error_code error;
    fs::remove(file.string() + suffix, error);
    if (error) throw Failure("'" + file.string() + suffix + "' can't be replaced: " + error.message());
  }
}

}  // namespace

TlogWriter::TlogWriter(const fs::path& file) {
  removeOld(file);
  parts_ = std::make_unique<Parts>(file);
  parts_->thread = std::thread([parts = parts_.get()] { parts->work(); });
}

TlogWriter::~TlogWriter() {
  try {
    close();
  } catch (const Failure&) {
    // errors are reported by close
  }
}

void TlogWriter::write(const Record& record) {
  std::unique_lock lock(parts_->mutex);
  parts_->taken.wait(lock, [&] { return parts_->failure || parts_->waiting.bytes.size() < kMostWaitingBytes; });
  if (parts_->failure) throw *parts_->failure;
  Batch& waiting = parts_->waiting;
  std::string& name = parts_->numbersKey;
  name.assign(record.topic).append("\n").append(record.type);
  const auto [known, isNew] = parts_->numbers.try_emplace(name, parts_->numbers.size());
  if (isNew) waiting.topics.emplace_back(record.topic, record.type);
  waiting.rows.push_back({record.timeNs, known->second, waiting.bytes.size(), record.payload.size()});
  waiting.bytes += record.payload;
  if (waiting.bytes.size() >= kMostWaitingBytes / 2) parts_->given.notify_one();
}

void TlogWriter::close() {
  if (parts_->thread.joinable()) {
    {
      const std::lock_guard lock(parts_->mutex);
      parts_->isClosing = true;
    }
    parts_->given.notify_one();
    parts_->thread.join();
  }
  if (parts_->failure) throw *parts_->failure;
}

}  // namespace pongsim::log
