#pragma once

#include <optional>

#include "pongsim/element.hh"
#include "pongsim/message.hh"

namespace pongsim::msgs {

/// Fills in an `ignition.msgs.GUI` as Fortress does: of each plugin of `<gui>` its name, its file, and what stands in
/// it.
/// @param gui The element as the file has it, or nothing: the message is empty.
void setGui(const std::optional<Element>& gui, Message& message);

}  // namespace pongsim::msgs
