#include "support/process.hh"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "support/regex.hh"

extern char** environ;

namespace pongsim::test {

namespace {

// Capacity of a pipe: pipe(7).
constexpr std::size_t kPipeSize = 65536;

std::vector<std::string> environmentWith(const std::map<std::string, std::string>& added) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!added.contains(text.substr(0, text.find('=')))) all.push_back(text);
  }
  for (const auto& [name, value] : added) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// @return A pipe whose reading end does not block.
std::array<int, 2> makePipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0 || fcntl(ends[0], F_SETFL, O_NONBLOCK) != 0) {
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  }
  return ends;
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const Options& options) {
  std::vector<std::string> argumentTexts = arguments;
  std::vector<std::string> environmentTexts = environmentWith(options.environment);
  const std::vector<char*> argumentPointers = pointers(argumentTexts);
  const std::vector<char*> environmentPointers = pointers(environmentTexts);
  const std::array<int, 2> output = makePipe();
  const std::array<int, 2> error = makePipe();
  if (pipe2(stop_, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const int input = open("/dev/null", O_RDONLY | O_CLOEXEC);

  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error(std::string("cannot fork: ") + std::strerror(errno));
  if (pid_ == 0) {
    // so that it ends even if the test crashes
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(input, STDIN_FILENO);
    dup2(output[1], STDOUT_FILENO);
    dup2(error[1], STDERR_FILENO);
    if (options.folder.empty() || chdir(options.folder.c_str()) == 0) {
      execvpe(argumentPointers[0], argumentPointers.data(), environmentPointers.data());
    }
    _exit(127);
  }
  close(input);
  close(output[1]);
  close(error[1]);
  output_.descriptor = output[0];
  error_.descriptor = error[0];
  reader_ = std::thread([this] { read(); });
}

Process::~Process() {
  if (!exitCode_) {
    kill(SIGKILL);
    wait();
  }
  close(stop_[1]);
  reader_.join();
  close(stop_[0]);
  close(output_.descriptor);
  close(error_.descriptor);
}

void Process::kill(int signal) const {
  if (!exitCode_) ::kill(pid_, signal);
}

std::optional<int> Process::wait(std::chrono::nanoseconds timeout) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (!exitCode_) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      exitCode_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    } else if (std::chrono::steady_clock::now() >= deadline) {
      return std::nullopt;
    } else {
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, std::chrono::milliseconds(2));
    }
  }

  // children of the process may keep the pipes open after it has ended
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::seconds(1), [this] { return readAll_; });
  lock.unlock();
  // what the process itself wrote is in the pipe, even if the reading thread has not run since
  takeFrom(output_);
  takeFrom(error_);
  return exitCode_;
}

void Process::read() {
  std::array<pollfd, 3> watched{
      {{output_.descriptor, POLLIN, 0}, {error_.descriptor, POLLIN, 0}, {stop_[0], POLLIN, 0}}};
  while (watched[0].fd >= 0 || watched[1].fd >= 0) {
    if (poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR) break;
    if (watched[0].revents != 0 && !takeFrom(output_)) watched[0].fd = -1;
    if (watched[1].revents != 0 && !takeFrom(error_)) watched[1].fd = -1;
    if (watched[2].revents != 0) break;
  }
  const std::lock_guard lock(mutex_);
  readAll_ = true;
  changed_.notify_all();
}

bool Process::takeFrom(Stream& stream) {
  const std::lock_guard lock(mutex_);
  std::array<char, kPipeSize> buffer;
  const ssize_t size = ::read(stream.descriptor, buffer.data(), buffer.size());
  if (size <= 0) return size < 0 && (errno == EINTR || errno == EAGAIN);
  stream.text.append(buffer.data(), static_cast<std::size_t>(size));
  changed_.notify_all();
  return true;
}

bool Process::waitFor(const Stream& stream, const std::string& pattern, std::chrono::nanoseconds timeout) {
  const Regex wanted(pattern);
  std::unique_lock lock(mutex_);
  const auto found = [&] { return wanted.isIn(stream.text); };
  changed_.wait_for(lock, timeout, [&] { return found() || readAll_; });
  return found();
}

bool Process::waitForOutput(const std::string& pattern, std::chrono::nanoseconds timeout) {
  return waitFor(output_, pattern, timeout);
}

bool Process::waitForError(const std::string& pattern, std::chrono::nanoseconds timeout) {
  return waitFor(error_, pattern, timeout);
}

std::string Process::output() const {
  const std::lock_guard lock(mutex_);
  return output_.text;
}

std::string Process::error() const {
  const std::lock_guard lock(mutex_);
  return error_.text;
}

}  // namespace pongsim::test
