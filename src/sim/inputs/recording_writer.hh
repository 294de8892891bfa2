#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>

#include "base/file_descriptor.hh"
#include "pongsim/outcome.hh"

namespace pongsim::sim {

struct RunStart;

/// Writes a file of recorded inputs. Each frame is written at once, so that a run that is killed leaves all but the
/// last. Thread-safe.
class RecordingWriter {
 public:
  /// Creates the file, or replaces it.
  /// @throws std::runtime_error if it can't be written.
  RecordingWriter(const std::filesystem::path& file, const RunStart& start);
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Appends a frame. After a failure it does nothing.
  void write(std::span<const std::byte> frame);
  /// @return Whether writing has failed. Cheap.
  bool hasFailed() const { return hasFailed_.load(std::memory_order_relaxed); }

  /// Completes the file.
  /// @return Or why it is not complete: "the inputs can't be recorded in 'FILE': No space left on device".
  Outcome<void> finish();

 private:
  void append(std::span<const std::byte> bytes);

  const std::filesystem::path path_;
  std::mutex mutex_;
  base::FileDescriptor file_;
  std::atomic<bool> hasFailed_ = false;
  std::string error_;
};

}  // namespace pongsim::sim
