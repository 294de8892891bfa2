#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// The text of an XML element without child elements.
struct XmlText {
  /// The path of element names from the root: "/sdf/model/link/.../mesh/uri".
  std::string path;
  /// Unescaped ("&amp;" is "&"), without surrounding space.
  std::string text;
  /// Its position in the file, without that space.
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Parses leniently and ends where the text is no longer XML. Skips comments and CDATA.
std::vector<XmlText> xmlTexts(std::string_view file);

/// @return The addresses of Fuel servers in a file: as text of XML elements, or in quotes in a metadata.pbtxt.
std::vector<std::string> fuelAddressesInXml(std::string_view file);
std::vector<std::string> fuelAddressesInQuotes(std::string_view file);

/// Changes a model's SDF file as Fortress does when it adds it to its cache: "model://NAME/FILE" of meshes, textures,
/// material scripts and animations is replaced by the file's address on the server, so that the model can be used in
/// any folder. All other bytes are kept.
/// @param address Must have a version.
/// @param has Whether the model contains a file; "model://" addresses of other files are kept.
template <class Has>
std::string withFuelAddresses(std::string_view file, const FuelAddress& address, const Has& has);

/// @return "FILE" for a "model://NAME/FILE" where Fortress replaces it; else empty.
std::string modelFile(const XmlText& text);

/// @return The address of a model's file as Fortress writes it, escaped for XML.
std::string xmlAddress(const FuelAddress& address, const std::string& file);

template <class Has>
std::string withFuelAddresses(std::string_view file, const FuelAddress& address, const Has& has) {
  std::string result;
  std::size_t done = 0;
  for (const XmlText& each : xmlTexts(file)) {
    const std::string path = modelFile(each);
    if (path.empty() || !has(path)) continue;
    result += file.substr(done, each.begin - done);
    result += xmlAddress(address, path);
    done = each.end;
  }
  return result += file.substr(done);
}

}  // namespace pongsim::fuel
