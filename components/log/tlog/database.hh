#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace pongsim::log {

/// An SQLite file, closed on destruction.
class Database {
 public:
  enum class Access { kCreate, kRead };

  /// @param uri URI of the file, with SQLite's parameters after a '?', or a plain path.
  /// @param file Its name in messages.
  /// @throws Failure if it can't be opened.
  Database(const std::string& uri, std::filesystem::path file, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::filesystem::path& file() const { return file_; }
  sqlite3* handle() const { return handle_; }

  /// Executes statements and discards their rows.
  /// @throws Failure if that fails.
  void run(const char* statements) const;
  /// @throws Failure with SQLite's error, or that the file can't be read or written, as in "'state.tlog' can't be
  /// written: database or disk is full".
  [[noreturn]] void fail() const;

 private:
  std::filesystem::path file_;
  Access access_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement, which can be executed any number of times.
class Statement {
 public:
  /// @throws Failure if the file lacks what it refers to.
  Statement(const Database& database, const char* text);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  // Parameters count from 1. Bound values must live until the next `reset`.
  void bind(int parameter, std::int64_t value);
  void bindText(int parameter, std::string_view text);
  void bindBytes(int parameter, std::string_view bytes);

  /// @return Whether there is another row.
  /// @throws Failure if the file can't be read or written, or is damaged.
  bool step();
  /// Like `step`; in a damaged file the rows end.
  bool stepWhole(bool& isDamaged);
  void reset();

  // Columns count from 0; texts are valid until the next step.
  std::int64_t number(int column) const;
  std::string_view text(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace pongsim::log
