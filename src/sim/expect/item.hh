#pragma once

#include <cstddef>
#include <list>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/expect/expectation.hh"
#include "sim/expect/evaluation.hh"
#include "sim/expect/event_record.hh"
#include "sim/expect/state_signal.hh"
#include "sim/expect/topic_field.hh"

namespace pongsim::sim {

struct Item;

/// An event of an expectation, and what was seen of it.
struct Watch {
  Watch(Item& owner, const Event& watched, Evaluation::Role itsRole, std::size_t itsNumber)
      : item(&owner),
        event(&watched),
        role(itsRole),
        number(itsNumber),
        record(watched),
        values(watched.criteria.size()) {}

  Item* item;
  const Event* event;
  Evaluation::Role role;
  std::size_t number;
  EventRecord record;
  std::vector<FieldValue> values;
  /// Of a topic: the fields in its messages, found with the first message of a type.
  std::vector<TopicField> fields;
  std::string type;
  /// Of anything else.
  StateSignal state;
};

/// An expectation of a monitor. Stays where it is, because its parts refer to each other.
struct Item {
  explicit Item(Expectation expected) : expectation(std::move(expected)), evaluation(expectation) {}
  Item(const Item&) = delete;
  Item& operator=(const Item&) = delete;

  bool isDecided() const { return !mistake.empty() || evaluation.isDecided(); }

  Expectation expectation;
  Evaluation evaluation;
  std::list<Watch> watches;
  /// Why it can't be judged.
  std::string mistake;
  Time mistakenAt{0};
};

}  // namespace pongsim::sim
