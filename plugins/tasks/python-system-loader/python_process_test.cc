#include "python_process.hh"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace pongsim::python_process_test {
namespace {

/// Answers with the number of words of what it is called with, after it has asked for each of them.
constexpr const char* kEcho = R"(
import socket, sys
stream = socket.socket(fileno=int(sys.argv[1])).makefile("rwb")
for line in stream:
    words = line.decode()[:-1].split("\t")
    if words[0] == "end":
        sys.exit(0)
    if words[0] == "refuse":
        stream.write(b"failed\tno\\nreason\n")
    else:
        answers = []
        for word in words:
            stream.write(("ask\t" + word + "\n").encode())
            stream.flush()
            answers.append(stream.readline().decode()[:-1].replace("\t", "="))
        stream.write(("done\t" + "\t".join(answers) + "\n").encode())
    stream.flush()
)";

Words nothing(const Words&) { return {}; }

TEST(Words, MayContainWhatEndsThem) {
  const Words words{"", "a\tb", "c\\n", "d\ne", "\\"};
  EXPECT_EQ(lineOf(words), "\ta\\tb\tc\\\\n\td\\ne\t\\\\\n");
  std::string line = lineOf(words);
  line.pop_back();
  EXPECT_EQ(wordsOf(line), words);
}

TEST(PythonProcess, AsksWhileItIsCalled) {
  PythonProcess process(kEcho, {});
  const auto answer = [](const Words& question) -> Words {
    if (question[0] == "bad") throw std::runtime_error("not known");
    return {question[0] + question[0]};
  };
  EXPECT_EQ(process.call({"a", "bad"}, answer), (Words{"ok=aa", "no=not known"}));
  EXPECT_EQ(process.call({"b"}, answer), Words{"ok=bb"});
}

TEST(PythonProcess, TellsWhyItFailedAndThatItHasEnded) {
  PythonProcess process(kEcho, {});
  try {
    process.call({"refuse"}, nothing);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no\nreason");
  }
  EXPECT_EQ(process.call({"a"}, nothing), Words{"ok"});
  EXPECT_THROW(process.call({"end"}, nothing), std::runtime_error);
  EXPECT_THROW(process.call({"a"}, nothing), std::runtime_error);
}

}  // namespace
}  // namespace pongsim::python_process_test
