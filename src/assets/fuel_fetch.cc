#include "assets/fuel_fetch.hh"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include "base/file_descriptor.hh"
#include "base/shared_library.hh"
#include "pongsim/files/fuel_address.hh"
#include "pongsim/log.hh"

namespace pongsim::assets {

namespace fs = std::filesystem;

namespace {

/// @return The program of this installation or build tree; empty if it is not installed.
fs::path installedProgram() {
  std::error_code ignored;
  // PREFIX/lib/libpongsim.so, PREFIX/lib/ARCHITECTURE/libpongsim.so, or a program with the library built in
  fs::path folder = base::ownLibraryFile().parent_path();
  for (int up = 0; up < 3 && folder.has_relative_path(); ++up) {
    folder = folder.parent_path();
    if (fs::path program = folder / "libexec/pongsim/pongsim-fuel"; fs::exists(program, ignored)) return program;
  }
  return {};
}

/// @return The model or world that an address belongs to, in a form that is the same for all its files.
std::optional<std::string> resourceOf(const std::string& address) {
  const std::optional<FuelAddress> parsed = parseFuelAddress(address);
  if (!parsed) return std::nullopt;
  return parsed->url() + "/" + (parsed->version ? std::to_string(*parsed->version) : "tip");
}

/// Writes the text to a file that a process can then read as its input.
bool fill(const base::FileDescriptor& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::lseek(file.number(), 0, SEEK_SET) == 0;
}

std::string readAll(const base::FileDescriptor& file) {
  std::string text;
  char part[4096];
  while (true) {
    const ssize_t count = ::read(file.number(), part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part, static_cast<std::size_t>(count));
  }
}

/// Starts a program with default signal handling, because the caller may have blocked the signals that end it.
/// @return 0, or the value of errno.
int spawn(const fs::path& program, int input, int output, ::pid_t& child) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  ::sigset_t none, ending;
  ::sigemptyset(&none);
  ::sigemptyset(&ending);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) ::sigaddset(&ending, signal);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &ending);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string name = program.string(), action = "fetch", option = "-v";
  // progress is only shown to users who want log messages at all
  std::string level = logLevel() < LogLevel::kWarning ? "1" : "3";
  char* const arguments[] = {name.data(), action.data(), option.data(), level.data(), nullptr};
  const int error = ::posix_spawn(&child, name.c_str(), &files, &attributes, arguments, environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  return error;
}

/// @return The text before the next tab, which is removed with it.
std::string takeField(std::string_view& line) {
  const std::string_view field = line.substr(0, line.find('\t'));
  line.remove_prefix(std::min(field.size() + 1, line.size()));
  return std::string(field);
}

}  // namespace

FuelFetch::FuelFetch(Places places, fs::path program)
    : places_(std::move(places)), program_(program.empty() ? installedProgram() : std::move(program)) {}

void FuelFetch::bring(const std::vector<std::string>& addresses) {
  std::vector<std::string> missing;
  for (const std::string& address : addresses) {
    const std::optional<std::string> resource = resourceOf(address);
    if (!resource || requested_.contains(*resource) || findInFuelCache(*parseFuelAddress(address), places_.fuelCache))
      continue;
    requested_.insert(*resource);
    missing.push_back(*resource);
  }
  if (!missing.empty() && !program_.empty() && !isFuelOffline()) run(missing);
}

void FuelFetch::run(const std::vector<std::string>& addresses) {
  const auto fail = [&](const std::string& why) {
    for (const std::string& address : addresses) failed_[address] = {why, {}};
  };
  std::string text;
  for (const std::string& address : addresses) text += address + "\n";
  const base::FileDescriptor input(::memfd_create("pongsim-fuel", MFD_CLOEXEC));
  int ends[2] = {-1, -1};
  const bool isPipe = ::pipe2(ends, O_CLOEXEC) == 0;
  const base::FileDescriptor output(ends[0]);
  base::FileDescriptor childOutput(ends[1]);
  if (!isPipe || input.number() < 0 || !fill(input, text)) return fail(std::strerror(errno));
  ::pid_t child = 0;
  if (const int error = spawn(program_, input.number(), childOutput.number(), child); error != 0) {
    return fail(program_.string() + " can't be run: " + std::strerror(error));
  }
  childOutput.close();
  const std::string answer = readAll(output);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  // one line for each finished address: "ok ADDRESS" or "failed ADDRESS TAB WHY TAB ADVICE"
  fail(WIFSIGNALED(status) ? "the download was interrupted" : "the download ended without a result");
  for (std::string_view rest = answer; !rest.empty();) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.starts_with("ok ")) failed_.erase(std::string(line.substr(3)));
    if (!line.starts_with("failed ")) continue;
    line.remove_prefix(7);
    const std::string address = takeField(line);
    const std::string why = takeField(line);
    failed_[address] = {why, takeField(line)};
  }
}

Problem FuelFetch::whyNot(const std::string& address) const {
  const std::string missing = "'" + address + "' is not in the local Fuel cache";
  if (isFuelOffline()) return {missing, "downloads are off: PONGSIM_OFFLINE or --offline is set"};
  if (program_.empty()) return {missing, "install pongsim-fuel to download it: apt-get install pongsim-fuel"};
  const std::optional<std::string> resource = resourceOf(address);
  const auto failed = resource ? failed_.find(*resource) : failed_.end();
  if (failed != failed_.end()) {
    return {"'" + address + "' can't be downloaded: " + failed->second.text, failed->second.hint};
  }
  return {missing, "there is no such model or file on the server"};
}

}  // namespace pongsim::assets
