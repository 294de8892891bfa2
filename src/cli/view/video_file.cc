#include "cli/view/video_file.hh"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>
#include <vector>

#include "base/child_process.hh"
#include "base/file_descriptor.hh"
#include "base/own_program.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

bool writeAll(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

/// The program while it runs.
class VideoFile::Program {
 public:
  Program(const std::filesystem::path& program, std::vector<std::string> arguments, int input, int images)
      : images_(images), thread_([this, program, arguments = std::move(arguments), input] {
          // open until the program has ended: then writes fail instead of waiting for a reader
          const base::FileDescriptor itsInput(input);
          result_ = base::runChild(program, arguments, input);
        }) {}
  ~Program() { finish(); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  int images() const { return images_.number(); }

  const Outcome<base::ChildResult>& finish() {
    images_.close();
    if (thread_.joinable()) thread_.join();
    return result_;
  }

 private:
  base::FileDescriptor images_;
  Outcome<base::ChildResult> result_;
  std::thread thread_;
};

VideoFile::VideoFile(std::unique_ptr<Program> program) : program_(std::move(program)) {}
VideoFile::~VideoFile() = default;

std::unique_ptr<VideoFile> VideoFile::begin(const ViewOptions& options, int rate) {
  const std::filesystem::path program = base::ownProgram("pongsim-video");
  if (program.empty()) {
    fail("videos need the package pongsim-video, which is not installed", "apt-get install pongsim-video");
    return nullptr;
  }
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    fail("a video can't be made: " + std::string(std::strerror(errno)));
    return nullptr;
  }
  std::vector<std::string> arguments{options.video, std::to_string(options.width), std::to_string(options.height),
                                     std::to_string(rate)};
  return std::unique_ptr<VideoFile>(
      new VideoFile(std::make_unique<Program>(program, std::move(arguments), ends[0], ends[1])));
}

bool VideoFile::add(std::int64_t frame, std::span<const std::uint8_t> pixels) {
  const bool isWritten = writeAll(program_->images(), {reinterpret_cast<const std::uint8_t*>(&frame), sizeof frame}) &&
                         writeAll(program_->images(), pixels);
  if (!isWritten) complete();
  return isWritten;
}

bool VideoFile::complete() {
  const Outcome<base::ChildResult>& result = program_->finish();
  if (!result) fail(result.error);
  // it has said itself what else went wrong
  if (result && WIFSIGNALED(result.value->status)) fail("the program that makes the video was ended by a signal");
  return result && result.value->status == 0;
}

}  // namespace pongsim::cli
