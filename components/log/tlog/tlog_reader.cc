#include "log/tlog/tlog_reader.hh"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "log/store/failure.hh"
#include "log/tlog/database.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kVersion = "0.1.0";

struct TopicName {
  std::string name;
  std::string type;
};

/// @return The file's name as an SQLite URI.
std::string uriOf(const fs::path& file, const char* parameters) {
  std::string uri = "file:";
  for (const char letter : file.string()) {
    if (letter == '%' || letter == '?' || letter == '#') {
      uri += letter == '%' ? "%25" : letter == '?' ? "%3f" : "%23";
    } else {
      uri += letter;
    }
  }
  return uri + "?" + parameters;
}

void readSchema(const Database& database) {
  // a file that is shorter than its header says is then read as far as it goes
  sqlite3_db_config(database.handle(), SQLITE_DBCONFIG_WRITABLE_SCHEMA, 1, nullptr);
  database.run("SELECT COUNT(*) FROM sqlite_master");
}

/// Opens a file that may be read-only, in a read-only folder.
std::unique_ptr<Database> openDatabase(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw Failure("there is no file '" + file.string() + "'",
                  fs::is_directory(file, error) ? "it is a folder: give the .tlog file in it" : "");
  }
  try {
    auto database = std::make_unique<Database>(uriOf(file, "mode=ro"), file, Database::Access::kRead);
    readSchema(*database);
    return database;
  } catch (const Failure&) {
    // it needs recovery, which a read-only folder prevents: read it as it is
    auto database = std::make_unique<Database>(uriOf(file, "mode=ro&immutable=1"), file, Database::Access::kRead);
    readSchema(*database);
    return database;
  }
}

/// @return The size of a database according to its header (SQLite's file format, 1.3) [bytes].
std::int64_t sizeByHeader(const fs::path& file) {
  std::array<unsigned char, 32> header{};
  std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(header.data()), header.size());
  const std::int64_t page = header[16] << 8 | header[17];
  std::int64_t count = 0;
  for (std::size_t i = 28; i < 32; ++i) count = count << 8 | header[i];
  // 1 stands for 65536, which does not fit into two bytes
  return count * (page == 1 ? 65536 : page);
}

}  // namespace

struct TlogReader::Parts {
  explicit Parts(const fs::path& file) : database(openDatabase(file)) {}

  void readTopics() {
    Statement rows(*database,
                   "SELECT topics.id, topics.name, message_types.name FROM topics JOIN message_types "
                   "ON topics.message_type_id = message_types.id");
    bool isDamaged = false;
    while (rows.stepWhole(isDamaged)) topics[rows.number(0)] = {std::string(rows.text(1)), std::string(rows.text(2))};
  }

  /// Looks for signs of a writer that was interrupted, or of an incomplete copy.
  void lookForTears(const fs::path& file) {
    std::error_code error;
    const auto size = static_cast<std::int64_t>(fs::file_size(file, error));
    const std::int64_t whole = sizeByHeader(file);
    const auto hasBeside = [&](const char* suffix) {
      return fs::exists(file.string() + suffix, error) && fs::file_size(file.string() + suffix, error) > 0;
    };
    if (hasBeside("-wal")) {
      tear = "'" + file.string() + "' was not closed or is still being written: the last second may be missing";
    } else if (hasBeside("-journal")) {
      tear = "'" + file.string() + "' was not closed: the last second is missing";
    } else if (size < whole) {
      isCutOff = true;
      tear = "'" + file.string() + "' is truncated: it has " + std::to_string(size) + " of " + std::to_string(whole) +
             " bytes";
    }
  }

  /// @return Ids of the topics as an SQL list; nothing: all.
  std::optional<std::string> idsOf(const std::optional<std::vector<std::string>>& names) const {
    if (!names) return std::nullopt;
    std::string list;
    for (const auto& [id, topic] : topics) {
      if (std::ranges::find(*names, topic.name) == names->end()) continue;
      list += (list.empty() ? "" : ",") + std::to_string(id);
    }
    return list;
  }

  std::unique_ptr<Database> database;
  std::map<std::int64_t, TopicName> topics;
  std::optional<std::string> tear;
  /// Its index is unusable: rows are read in the order of writing.
  bool isCutOff = false;
  /// The last row at the time of opening.
  std::int64_t lastRow = 0;
  std::optional<std::vector<Topic>> counted;
};

TlogReader::TlogReader(const fs::path& file) : parts_(std::make_unique<Parts>(file)) {
  const Database& database = *parts_->database;
  std::string version;
  try {
    Statement statement(database, "SELECT to_version FROM migrations ORDER BY id DESC LIMIT 1");
    if (statement.step()) version = statement.text(0);
  } catch (const Failure& why) {
    if (!why.hint().empty()) throw;
    throw Failure("'" + file.string() + "' is not a tlog: it has no table of migrations");
  }
  if (version != kVersion)
    throw Failure("'" + file.string() + "' is a tlog of version '" + version + "', not of " + std::string(kVersion));
  parts_->readTopics();
  parts_->lookForTears(file);
  if (parts_->isCutOff) {
    parts_->lastRow = std::numeric_limits<std::int64_t>::max();
  } else {
    Statement last(database, "SELECT MAX(id) FROM messages");
    if (last.step()) parts_->lastRow = last.number(0);
  }
}

TlogReader::~TlogReader() = default;

std::vector<Topic> TlogReader::topics() const {
  if (parts_->counted) return *parts_->counted;
  std::map<std::int64_t, std::uint64_t> counts;
  Statement rows(*parts_->database, "SELECT topic_id FROM messages WHERE id <= ?1 ORDER BY id");
  rows.bind(1, parts_->lastRow);
  bool isDamaged = false;
  while (rows.stepWhole(isDamaged)) ++counts[rows.number(0)];
  std::vector<Topic> topics;
  for (const auto& [id, topic] : parts_->topics) topics.push_back({topic.name, topic.type, counts[id]});
  std::ranges::sort(topics,
                    [](const Topic& a, const Topic& b) { return std::tie(a.name, a.type) < std::tie(b.name, b.type); });
  parts_->counted = topics;
  return topics;
}

std::vector<std::string> TlogReader::topicsOf(std::string_view type) const {
  std::vector<std::string> names;
  for (const auto& [id, topic] : parts_->topics) {
    if (topic.type == type) names.push_back(topic.name);
  }
  return names;
}

std::optional<TimeRange> TlogReader::timeRange() const {
  std::optional<TimeRange> range;
  if (parts_->isCutOff) {
    forEach({}, [&](const Record& record) {
      if (!range) range = {record.timeNs, record.timeNs};
      range = {std::min(range->first, record.timeNs), std::max(range->last, record.timeNs)};
      return true;
    });
    return range;
  }
  // two queries, so that each uses the index
  Statement first(*parts_->database, "SELECT time_recv FROM messages ORDER BY time_recv LIMIT 1");
  Statement last(*parts_->database, "SELECT time_recv FROM messages WHERE id <= ?1 ORDER BY time_recv DESC LIMIT 1");
  last.bind(1, parts_->lastRow);
  if (first.step() && last.step()) range = {first.number(0), last.number(0)};
  return range;
}

void TlogReader::forEach(const Selection& selection, const std::function<bool(const Record&)>& visit) const {
  const std::optional<std::string> ids = parts_->idsOf(selection.topics);
  // the plus disables the index
  const std::string time = parts_->isCutOff ? "+time_recv" : "time_recv";
  const std::string text = "SELECT time_recv, topic_id, message FROM messages WHERE " + time +
                           " BETWEEN ?1 AND ?2 AND +id <= ?3" + (ids ? " AND topic_id IN (" + *ids + ")" : "") +
                           " ORDER BY " + (parts_->isCutOff ? "id" : "time_recv, id");
  Statement rows(*parts_->database, text.c_str());
  rows.bind(1, selection.from);
  rows.bind(2, selection.to);
  rows.bind(3, parts_->lastRow);
  bool isDamaged = false;
  while (parts_->isCutOff ? rows.stepWhole(isDamaged) : rows.step()) {
    const auto topic = parts_->topics.find(rows.number(1));
    if (topic == parts_->topics.end()) continue;
    if (!visit({rows.number(0), topic->second.name, topic->second.type, rows.text(2)})) return;
  }
}

std::optional<std::string> TlogReader::torn() const { return parts_->tear; }

}  // namespace pongsim::log
