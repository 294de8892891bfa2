#pragma once

#include <string_view>
#include <vector>

namespace pongsim::test {

/// What happens to a world between two steps.
enum class Operation {
  /// Inserts the kind's models under their names, if those are free.
  kInsert,
  /// Inserts a copy of the first model.
  kCopy,
  /// Inserts the first model under another name, its topics in a namespace.
  kInsertWithin,
  kRemoveFirst,
  kRemoveAll,
  /// Moves each model.
  kMove,
  kReset,
  kSave,
  kRestore,
  /// The performer leaves, so that what is in its level is set aside; or it returns.
  kLeave,
  kReturn,
  /// Subscribes to all topics, or ends that.
  kListen,
  kDeafen,
  /// Publishes the kind's commands, and an empty message on every other topic to which systems subscribe.
  kCommand,
  /// Inserts a light or, if it is there, removes it.
  kLight,
  /// Attaches the last model to the first one or, if that was done, detaches it.
  kAttach,
  /// Steps while time stands still.
  kPause,
};
inline constexpr int kOperations = 17;

std::string_view nameOf(Operation operation);

/// @return The shortest sequence in which each operation follows each, itself included (a de Bruijn sequence).
std::vector<Operation> allPairs();

/// @return All sequences of three operations that change which models there are or where, each after a reset.
std::vector<Operation> allTriples();

}  // namespace pongsim::test
