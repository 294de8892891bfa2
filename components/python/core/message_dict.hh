#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <span>
#include <string>

#include "pongsim/message.hh"

namespace pongsim::python {

namespace py = pybind11;

/// @return The full name of a message type.
/// Raises ValueError, suggesting the type with the most similar name, if there is none.
std::string knownType(const std::string& name);

/// @return A message as a dict keyed by field name: numbers, strings, bytes, lists, dicts, names of enumerators.
/// Contains all scalar fields, and those nested messages that are set.
py::dict dictOf(const Message& message);

/// Fills a message from a dict like those of `dictOf`, in which missing fields keep their defaults; from protobuf's
/// text format; or from an object of the type's own Python class. Raises ValueError and TypeError that name the field.
void fillIn(Message& message, py::handle from);

/// @return The message type of an object of a message's Python class; empty for a dict, a string and the like.
std::string typeOfObject(py::handle object);

/// @return The message in the form that `type` asks for: null or None: a dict; `bytes`: protobuf's binary format; a
/// message's Python class: an object of it.
py::object messageAs(py::handle type, const std::string& name, std::span<const std::byte> bytes);

/// @return The file that defines a message type and those that it imports, as FileDescriptorProto in binary form, each
/// after its own imports.
py::list filesOf(const std::string& type);

}  // namespace pongsim::python
