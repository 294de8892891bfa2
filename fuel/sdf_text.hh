#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// The text of an element without elements in it, in an XML file.
struct XmlText {
  /// The names of the elements that it is in, from the root on, with "/" before each: "/sdf/model/link/.../mesh/uri".
  std::string path;
  /// With "&amp;" made "&" and so on, without space around it.
  std::string text;
  /// Where it stands in the file, that space left out.
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Reads as leniently as may be: what is no XML any more ends it. Comments and CDATA are passed over.
std::vector<XmlText> xmlTexts(std::string_view file);

/// @return The addresses of Fuel servers that a file names: as the text of elements in XML, or in quotes in a
/// metadata.pbtxt.
std::vector<std::string> fuelAddressesInXml(std::string_view file);
std::vector<std::string> fuelAddressesInQuotes(std::string_view file);

/// Does with a model's SDF file what Fortress does when it puts it into the cache: meshes, textures, material scripts
/// and animations of "model://NAME/FILE" become the addresses of these files on the server, by which they are found
/// again wherever the model is. The rest stays as it is, byte by byte.
/// @param address With the version.
/// @param has Whether the model has a file; "model://" of what it has not stays.
template <class Has>
std::string withFuelAddresses(std::string_view file, const FuelAddress& address, const Has& has);

/// @return "FILE" of a "model://NAME/FILE" that stands where Fortress replaces it; else empty.
std::string modelFile(const XmlText& text);

/// @return As Fortress writes the address of a model's file, ready to stand in XML.
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
