#pragma once

#include "log/store/record.hh"

namespace pongsim::log {

/// Writes a log. What `write` has taken is in the file a second later, whatever becomes of the process.
class Writer {
 public:
  virtual ~Writer() = default;

  /// Takes a record. The times of records need not ascend.
  /// @param record What its views name is copied before this returns.
  /// @throws Failure where this or an earlier record can't be written, as where the disk is full. What has been written
  /// by then stays readable, and all calls to come throw the same.
  virtual void write(const Record& record) = 0;

  /// Waits until all is in the file, and ends it. A second call does nothing; a writer that is destroyed does it too,
  /// and keeps what fails to itself.
  /// @throws Failure as `write` does.
  virtual void close() = 0;
};

}  // namespace pongsim::log
