#include "python_process.hh"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace pongsim {

namespace {

/// Of the socket in the program.
constexpr int kItsSocket = 3;
/// How long it may take to end [ms].
constexpr int kPatience = 5000;

[[noreturn]] void fail(const std::string& what, int error) {
  throw std::runtime_error(what + ": " + std::strerror(error));
}

/// With default handling of signals, because this process may have blocked those that end it.
pid_t start(const std::vector<std::string>& words, int socket) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, kItsSocket);
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t process = -1;
  const int error = posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return error == 0 ? process : -error;
}

/// Waits for its end, and ends it if it does not.
void await(pid_t process) {
  const int handle = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
  pollfd end{handle, POLLIN, 0};
  if (handle < 0 || poll(&end, 1, kPatience) <= 0) kill(process, SIGKILL);
  if (handle >= 0) close(handle);
  while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

std::string lineOf(const Words& words) {
  std::string line;
  for (const std::string& word : words) {
    if (&word != words.data()) line += '\t';
    for (const char letter : word) {
      if (letter == '\\') {
        line += "\\\\";
      } else if (letter == '\t') {
        line += "\\t";
      } else if (letter == '\n') {
        line += "\\n";
      } else {
        line += letter;
      }
    }
  }
  return line + '\n';
}

Words wordsOf(const std::string& line) {
  Words words(1);
  bool isEscaped = false;
  for (const char letter : line) {
    if (isEscaped) {
      words.back() += letter == 't' ? '\t' : letter == 'n' ? '\n' : letter;
      isEscaped = false;
    } else if (letter == '\\') {
      isEscaped = true;
    } else if (letter == '\t') {
      words.emplace_back();
    } else {
      words.back() += letter;
    }
  }
  return words;
}

PythonProcess::PythonProcess(const std::string& program, const std::vector<std::string>& arguments) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail("there is no socket for Python", errno);
  std::vector<std::string> words{"python3", "-c", program, std::to_string(kItsSocket)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  socket_ = ends[0];
  process_ = start(words, ends[1]);
  close(ends[1]);
  if (process_ > 0) return;
  close(socket_);
  fail("python3 can't be run", -process_);
}

PythonProcess::~PythonProcess() {
  close(socket_);
  await(process_);
}

Words PythonProcess::call(const Words& words, const Answer& answer) {
  send(words);
  for (;;) {
    Words said = receive();
    const std::string kind = said[0];
    said.erase(said.begin());
    if (kind == "done") return said;
    if (kind == "failed") throw std::runtime_error(said.empty() ? "it failed" : said[0]);
    try {
      Words answered = answer(said);
      answered.insert(answered.begin(), "ok");
      send(answered);
    } catch (const std::runtime_error& error) {
      send({"no", error.what()});
    }
  }
}

void PythonProcess::send(const Words& words) const {
  const std::string line = lineOf(words);
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t sent = ::send(socket_, line.data() + done, line.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) throw std::runtime_error("its Python process has ended");
    done += static_cast<std::size_t>(sent);
  }
}

Words PythonProcess::receive() {
  std::size_t end = std::string::npos;
  while ((end = pending_.find('\n')) == std::string::npos) {
    char buffer[4096];
    const ssize_t size = recv(socket_, buffer, sizeof(buffer), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) throw std::runtime_error("its Python process has ended");
    pending_.append(buffer, static_cast<std::size_t>(size));
  }
  Words words = wordsOf(pending_.substr(0, end));
  pending_.erase(0, end + 1);
  return words;
}

}  // namespace pongsim
