#pragma once

#include <filesystem>
#include <memory>

#include "log/store/writer.hh"

namespace pongsim::log {

/// Writes Fortress's log files: an SQLite database with schema 0.1.0 of ignition-transport's logs. Writing happens on a
/// thread of its own, with half a second of records in each transaction, or
/// 1 MiB if there are more. Meanwhile a file NAME-wal belongs to the log.
class TlogWriter final : public Writer {
 public:
  /// @param file Replaced if it exists.
  /// @throws Failure if it can't be created.
  explicit TlogWriter(const std::filesystem::path& file);
  ~TlogWriter() override;

  /// See `Writer::write`. Blocks while 64 MiB are waiting to be written.
  void write(const Record& record) override;
  void close() override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::log
