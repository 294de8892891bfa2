#include "log/tlog/database.hh"

#include <sqlite3.h>

#include <utility>

#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

/// Waiting time of a writer for a reader of the same file [ms].
constexpr int kBusyTime = 10000;

const char* hintFor(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "free disk space";
    case SQLITE_NOTADB:
      return "a tlog file is an SQLite database, such as Fortress's state.tlog";
    case SQLITE_CORRUPT:
      return "it was truncated or changed while it was copied";
    default:
      return "";
  }
}

}  // namespace

Database::Database(const std::string& uri, std::filesystem::path file, Access access)
    : file_(std::move(file)), access_(access) {
  const int how = access == Access::kCreate ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY;
  const int code = sqlite3_open_v2(uri.c_str(), &handle_, how | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  if (code == SQLITE_OK) {
    sqlite3_extended_result_codes(handle_, 1);
    sqlite3_busy_timeout(handle_, kBusyTime);
    return;
  }
  const std::string why = handle_ == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(handle_);
  sqlite3_close_v2(handle_);
  throw Failure("'" + file_.string() + "' can't be opened: " + why);
}

Database::~Database() { sqlite3_close_v2(handle_); }

void Database::run(const char* statements) const {
  if (sqlite3_exec(handle_, statements, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void Database::fail() const {
  const int code = sqlite3_errcode(handle_);
  throw Failure("'" + file_.string() + "' can't be " + (access_ == Access::kCreate ? "written" : "read") + ": " +
                    sqlite3_errmsg(handle_),
                hintFor(code));
}

Statement::Statement(const Database& database, const char* text) : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), text, -1, &handle_, nullptr) != SQLITE_OK) database.fail();
}

Statement::~Statement() { sqlite3_finalize(handle_); }

void Statement::bind(int parameter, std::int64_t value) {
  if (sqlite3_bind_int64(handle_, parameter, value) != SQLITE_OK) database_.fail();
}

void Statement::bindText(int parameter, std::string_view text) {
  if (sqlite3_bind_text(handle_, parameter, text.data(), static_cast<int>(text.size()), SQLITE_STATIC) != SQLITE_OK)
    database_.fail();
}

void Statement::bindBytes(int parameter, std::string_view bytes) {
  // the address of an empty view may be null, which would be NULL
  const void* const data = bytes.empty() ? "" : bytes.data();
  if (sqlite3_bind_blob64(handle_, parameter, data, bytes.size(), SQLITE_STATIC) != SQLITE_OK) database_.fail();
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.fail();
  return false;
}

bool Statement::stepWhole(bool& isDamaged) {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  const int kind = code & 0xff;
  isDamaged = kind == SQLITE_CORRUPT || kind == SQLITE_IOERR;
  if (code != SQLITE_DONE && !isDamaged) database_.fail();
  return false;
}

void Statement::reset() { sqlite3_reset(handle_); }

std::int64_t Statement::number(int column) const { return sqlite3_column_int64(handle_, column); }

std::string_view Statement::text(int column) const {
  // the bytes first: their size refers to the last requested form
  const auto* const bytes = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  return {bytes == nullptr ? "" : bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))};
}

}  // namespace pongsim::log
