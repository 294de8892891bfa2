#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/expect/expectation.hh"
#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "sim/expect/criterion.hh"

namespace pongsim::sim {

/// The contact points of a step, read once for all that watch them.
using ContactPoints = std::vector<Contact>;

/// Reads the fields of something that has a value after each step.
struct StateSignal {
  /// Puts the values into the places, one for each criterion.
  /// @return Whether there are any: what is watched may have been removed.
  std::function<bool(std::span<FieldValue>)> read;
  /// For each criterion, whether its field is an angle of which full turns do not count.
  std::vector<bool> isAngle = {};
};

/// @param event Of any kind but kTopic.
/// @param contacts Of the last step whenever it is read; must outlive the result.
/// @return Why it can't be watched: "there is no model 'x' (did you mean 'y'?)".
Outcome<StateSignal> stateSignal(World world, const Event& event, const ContactPoints& contacts);

}  // namespace pongsim::sim
