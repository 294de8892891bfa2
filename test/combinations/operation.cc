#include "combinations/operation.hh"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace pongsim::test {

std::string_view nameOf(Operation operation) {
  constexpr std::array<std::string_view, kOperations> kNames = {
      "insert", "copy",   "insert within", "remove the first", "remove all", "move",  "reset",  "save", "restore",
      "leave",  "return", "listen",        "deafen",           "command",    "light", "attach", "pause"};
  return kNames.at(static_cast<std::size_t>(operation));
}

std::vector<Operation> allPairs() {
  // the Lyndon words of length 1 and 2 in order
  std::vector<Operation> sequence;
  for (int first = 0; first < kOperations; ++first) {
    sequence.push_back(static_cast<Operation>(first));
    for (int second = first + 1; second < kOperations; ++second) {
      sequence.push_back(static_cast<Operation>(first));
      sequence.push_back(static_cast<Operation>(second));
    }
  }
  // it is a cycle
  sequence.push_back(sequence.front());
  return sequence;
}

std::vector<Operation> allTriples() {
  using enum Operation;
  constexpr std::array kChanges = {kInsert, kCopy,    kInsertWithin, kRemoveFirst, kRemoveAll, kMove,
                                   kSave,   kRestore, kLeave,        kReturn,      kAttach};
  std::vector<Operation> sequence;
  for (const Operation first : kChanges) {
    for (const Operation second : kChanges) {
      for (const Operation third : kChanges) sequence.insert(sequence.end(), {kReset, first, second, third});
    }
  }
  return sequence;
}

}  // namespace pongsim::test
