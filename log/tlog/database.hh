#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace pongsim::log {

/// A file of SQLite, which closes itself.
class Database {
 public:
  enum class Access { kCreate, kRead };

  /// @param uri Of the file, with SQLite's parameters behind a '?', or a plain path.
  /// @param file For what is said of it.
  /// @throws Failure where it can't be opened.
  Database(const std::string& uri, std::filesystem::path file, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::filesystem::path& file() const { return file_; }
  sqlite3* handle() const { return handle_; }

  /// Carries statements out, whose rows nobody wants.
  /// @throws Failure where it can't.
  void run(const char* statements) const;
  /// @return What SQLite says of a failure, or that it can't read or write, as "'state.tlog' can't be written: database
  /// or disk is full".
  [[noreturn]] void fail() const;

 private:
  std::filesystem::path file_;
  Access access_;
  sqlite3* handle_ = nullptr;
};

/// A statement that is carried out as often as one likes.
class Statement {
 public:
  /// @throws Failure where the file has not what it is about.
  Statement(const Database& database, const char* text);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  // Parameters count from 1. What is bound must live until the next `reset`.
  void bind(int parameter, std::int64_t value);
  void bindText(int parameter, std::string_view text);
  void bindBytes(int parameter, std::string_view bytes);

  /// @return Whether there is a row; false where there is none any more.
  /// @throws Failure where the file can't be read or written, or is damaged.
  bool step();
  /// As `step`; a damaged file ends the rows.
  bool stepWhole(bool& isDamaged);
  void reset();

  // Columns count from 0; texts live until the next step.
  std::int64_t number(int column) const;
  std::string_view text(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace pongsim::log
