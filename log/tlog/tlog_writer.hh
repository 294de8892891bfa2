#pragma once

#include <filesystem>
#include <memory>

#include "log/store/writer.hh"

namespace pongsim::log {

/// Writes Fortress's log files: a database of SQLite, by schema 0.1.0 of ignition-transport's logs. A thread of its own
/// does so, half a second's records in each transaction. While it is written a file NAME-wal belongs to it.
class TlogWriter final : public Writer {
 public:
  /// @param file Replaced where it is there.
  /// @throws Failure where it can't be made.
  explicit TlogWriter(const std::filesystem::path& file);
  ~TlogWriter() override;

  /// As `Writer::write`. Waits where 64 MiB wait to be written.
  void write(const Record& record) override;
  void close() override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::log
