#include "cli/extension/extension_world.hh"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <vector>

#include "cli/own_folder.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// Starts a program with default signal handling, because this process may have blocked the signals that end it.
/// @param output Gets what it prints.
/// @return 0, or the value of errno.
int start(const std::filesystem::path& program, const std::vector<std::string>& arguments, int output, ::pid_t& child) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&attributes);
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

std::string readAll(int file) {
  std::string text;
  char part[65536];
  while (true) {
    const ssize_t count = ::read(file, part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part, static_cast<std::size_t>(count));
  }
}

}  // namespace

std::optional<std::string> printedWorld(const Extension::WorldSource& source) {
  const std::filesystem::path program = ownFolder().parent_path().parent_path() / "libexec/pongsim" / source.program;
  int ends[2];
  ::pid_t child = 0;
  const bool hasPipe = ::pipe2(ends, O_CLOEXEC) == 0;
  const int error = hasPipe ? start(program, source.arguments, ends[1], child) : errno;
  if (hasPipe) ::close(ends[1]);
  std::string text;
  if (hasPipe && error == 0) text = readAll(ends[0]);
  if (hasPipe) ::close(ends[0]);
  if (error != 0) {
    fail(program.string() + " can't be run: " + std::strerror(error));
    return std::nullopt;
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return text;
}

}  // namespace pongsim::cli
