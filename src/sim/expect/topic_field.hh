#pragma once

#include <optional>
#include <string>

#include "pongsim/message.hh"
#include "pongsim/messages/field_path.hh"
#include "pongsim/outcome.hh"
#include "sim/expect/criterion.hh"

namespace pongsim::sim {

/// The field of a topic's messages that a criterion is about.
class TopicField {
 public:
  /// @param type Of the messages.
  /// @return Why there is no such field, or why the criterion does not fit it, with a hint in brackets.
  static Outcome<TopicField> of(const Criterion& criterion, const std::string& type);

  FieldValue in(const Message& message) const;

 private:
  /// What is made of a list of numbers.
  enum class Fold { kNone, kMin, kMax, kMean, kSize };
  TopicField(FieldPath path, Fold fold) : path_(std::move(path)), fold_(fold) {}

  FieldPath path_;
  Fold fold_;
};

}  // namespace pongsim::sim
