#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// Makes relative file addresses in an element absolute, so that they still hold when it is moved to another file.
/// Leaves plugins and addresses that do not name files unchanged.
/// @param folder Folder of the element's file.
void makeAddressesAbsolute(Element& element, const std::filesystem::path& folder);

/// @return The addresses on Fuel servers in an element and everything below it, including plugins.
std::vector<std::string> fuelAddressesIn(const Element& element);

}  // namespace pongsim::sdf
