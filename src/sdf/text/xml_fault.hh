#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::sdf {

/// Why a text is not well-formed XML.
struct XmlFault {
  /// Where in the text.
  std::size_t offset = 0;
  std::string message;
  std::string hint;
};

/// Looks for the first fault of a text that the XML parser has refused, to say more than the parser does.
/// @return Nothing where no fault of a known kind is found.
std::optional<XmlFault> findXmlFault(std::string_view text);

}  // namespace pongsim::sdf
