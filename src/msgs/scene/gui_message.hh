#pragma once

#include <optional>

#include "pongsim/element.hh"
#include "pongsim/message.hh"

namespace pongsim::msgs {

/// Fills in an `ignition.msgs.GUI` as Fortress does: the name, file and content of each plugin of `<gui>`.
/// @param gui The element as in the file; nothing: the message is empty.
void setGui(const std::optional<Element>& gui, Message& message);

}  // namespace pongsim::msgs
