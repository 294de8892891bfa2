#include "base/child_process.hh"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "base/file_descriptor.hh"

namespace pongsim::base {

namespace {

/// @return 0, or the value of errno.
int startChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::optional<int>& input, int output, ::pid_t& child) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&attributes);
  if (input) ::posix_spawn_file_actions_adddup2(&files, *input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  ::sigset_t none, ending;
  ::sigemptyset(&none);
  ::sigemptyset(&ending);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) ::sigaddset(&ending, signal);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &ending);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const int error = ::posix_spawn(&child, words.front().c_str(), &files, &attributes, argv.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  return error;
}

std::string readToEnd(const FileDescriptor& file) {
  std::string text;
  char part[65536];
  while (true) {
    const ssize_t count = ::read(file.number(), part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part, static_cast<std::size_t>(count));
  }
}

}  // namespace

Outcome<ChildResult> runChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                              std::optional<int> input) {
  int ends[2] = {-1, -1};
  int error = ::pipe2(ends, O_CLOEXEC) == 0 ? 0 : errno;
  const FileDescriptor output(ends[0]);
  FileDescriptor childOutput(ends[1]);
  ::pid_t child = 0;
  if (error == 0) error = startChild(program, arguments, input, childOutput.number(), child);
  if (error != 0) return {{}, program.string() + " can't be run: " + std::strerror(error)};
  childOutput.close();
  ChildResult result{readToEnd(output), 0};
  while (::waitpid(child, &result.status, 0) < 0 && errno == EINTR) {
  }
  return {std::move(result), {}};
}

}  // namespace pongsim::base
