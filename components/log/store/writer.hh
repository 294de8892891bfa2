#pragma once

#include "log/store/record.hh"

namespace pongsim::log {

/// Writes a log. A record passed to `write` is in the file a second later, whatever happens to the process.
class Writer {
 public:
  virtual ~Writer() = default;

  /// Writes a record. Times need not be in order.
  /// @param record Its data is copied before this returns.
  /// @throws Failure if this or an earlier record can't be written, for example because the disk is full. What was
  /// written by then stays readable, and all further calls throw the same.
  virtual void write(const Record& record) = 0;

  /// Waits until everything is in the file, and closes it. A second call does nothing. The destructor does the same,
  /// and ignores failures.
  /// @throws Failure like `write`.
  virtual void close() = 0;
};

}  // namespace pongsim::log
