#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// Makes the relative addresses of files in an element absolute, so that they stay true where it is put into another
/// file. What is in a plugin, and what names no file, stays as it is.
/// @param folder That of the element's file.
void makeAddressesAbsolute(Element& element, const std::filesystem::path& folder);

/// @return The addresses of Fuel servers that stand in an element or anywhere below, in plugins too.
std::vector<std::string> fuelAddressesIn(const Element& element);

}  // namespace pongsim::sdf
