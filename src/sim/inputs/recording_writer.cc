#include "sim/inputs/recording_writer.hh"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "sim/inputs/recording.hh"

namespace pongsim::sim {

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const RunStart& start)
    : path_(file), file_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (!file_.isOpen()) {
    throw std::runtime_error("can't record inputs in '" + path_.string() + "': " + std::strerror(errno));
  }
  append(std::as_bytes(std::span(kRecordingMark)));
  append(frameWith(FrameKind::kStart, start));
  if (hasFailed_) throw std::runtime_error(error_);
}

void RecordingWriter::write(std::span<const std::byte> frame) {
  const std::lock_guard lock(mutex_);
  append(frame);
}

void RecordingWriter::append(std::span<const std::byte> bytes) {
  while (!bytes.empty() && !hasFailed_) {
    const ssize_t written = ::write(file_.number(), bytes.data(), bytes.size());
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error_ = "can't record inputs in '" + path_.string() + "': " + std::strerror(errno);
      hasFailed_ = true;
    }
  }
}

Outcome<void> RecordingWriter::finish() {
  const std::lock_guard lock(mutex_);
  append(frameOf(FrameKind::kEnd, {}));
  if (!file_.close() && !hasFailed_) {
    error_ = "can't record inputs in '" + path_.string() + "': " + std::strerror(errno);
    hasFailed_ = true;
  }
  return {error_};
}

}  // namespace pongsim::sim
