#include "pongsim/files/parameter_picture.hh"

#include <utility>
#include <variant>

#include "assets/images/picture_file.hh"
#include "pongsim/files/parameter_file.hh"

namespace pongsim {

ParameterPicture parameterPicture(const Element& element) {
  auto read = assets::decodePicture(parameterFile(element, assets::kLargestPictureFile));
  if (const auto* problem = std::get_if<assets::Problem>(&read)) {
    throw Error({Severity::kError, element.position, "'" + element.text + "' " + problem->text, problem->hint});
  }
  auto& picture = std::get<assets::Picture>(read);
  return {picture.width, picture.height, std::move(picture.pixels)};
}

}  // namespace pongsim
