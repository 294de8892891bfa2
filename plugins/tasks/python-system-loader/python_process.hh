#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace pongsim {

/// Words of a line: between tabs, with `\\`, `\t` and `\n` for the characters that would end them.
using Words = std::vector<std::string>;

/// @return The line, with its end.
std::string lineOf(const Words& words);
/// @param line Without its end.
Words wordsOf(const std::string& line);

/// A Python program that takes turns with this one on a socket, whose number is its first argument. A call ends with
/// "done" or "failed REASON"; until then the program may ask: "ask WORDS", answered by "ok WORDS" or "no REASON".
class PythonProcess {
 public:
  /// @throws std::runtime_error for a question that has no answer.
  using Answer = std::function<Words(const Words& question)>;

  /// Starts `python3`.
  /// @throws std::runtime_error if that fails.
  PythonProcess(const std::string& program, const std::vector<std::string>& arguments);
  PythonProcess(const PythonProcess&) = delete;
  PythonProcess& operator=(const PythonProcess&) = delete;
  /// Lets it end, for which it has some seconds.
  ~PythonProcess();

  /// @return The words behind "done".
  /// @throws std::runtime_error with the reason if it failed or has ended.
  Words call(const Words& words, const Answer& answer);

 private:
  void send(const Words& words) const;
  Words receive();

  int socket_ = -1;
  pid_t process_ = -1;
  /// Received, and not yet taken.
  std::string pending_;
};

}  // namespace pongsim
