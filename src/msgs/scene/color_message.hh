#pragma once

#include "description/color.hh"

namespace pongsim::msgs {

/// @param message An ignition.msgs.Color.
template <class Message>
void setColor(const description::Color& color, Message& message) {
  message.set_r(color.red);
  message.set_g(color.green);
  message.set_b(color.blue);
  message.set_a(color.alpha);
}

/// @param message An ignition.msgs.Color.
template <class Message>
description::Color colorOf(const Message& message) {
  return {message.r(), message.g(), message.b(), message.a()};
}

}  // namespace pongsim::msgs
