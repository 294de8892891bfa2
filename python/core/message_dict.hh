#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <span>
#include <string>

#include "pongsim/message.hh"

namespace pongsim::python {

namespace py = pybind11;

/// @return The full name of a message type.
/// Raises ValueError, with the type that is spelt most like it, where there is none.
std::string knownType(const std::string& name);

/// @return A message as a dict by the names of its fields: numbers, texts, bytes, lists, dicts, names of enumerators.
/// All single values are there; inner messages where they are set.
py::dict dictOf(const Message& message);

/// Fills a message from a dict as `dictOf` makes them, in which what is left out stays at its default; from protobuf's
/// text format; or from the type's own Python class. Raises ValueError and TypeError that name the field.
void fillIn(Message& message, py::handle from);

/// @return What an object of a message's own Python class says its type is; empty for a dict, a text and the like.
std::string typeOfObject(py::handle object);

/// @return The message as `type` wants it: null or None: a dict; `bytes`: protobuf's binary form; a message's own
/// Python class: an object of it.
py::object messageAs(py::handle type, const std::string& name, std::span<const std::byte> bytes);

/// @return A message type's file and those that it needs, as FileDescriptorProto in binary form, each behind those that
/// it needs itself.
py::list filesOf(const std::string& type);

}  // namespace pongsim::python
