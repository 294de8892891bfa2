#pragma once

#include "pongsim/background_calls.hh"
#include "pongsim/element.hh"

namespace pongsim {

/// @param element A `<service>` of a TriggeredPublisher.
/// @return The call that it describes.
/// @throws Error at the element that is missing or wrong.
BackgroundCalls::Call serviceCall(const Element& element);

}  // namespace pongsim
