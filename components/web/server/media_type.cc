#include "web/server/media_type.hh"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

namespace pongsim::web {

namespace {

constexpr std::pair<std::string_view, std::string_view> kTypes[] = {{".bin", "application/octet-stream"},
                                                                    {".bmp", "image/bmp"},
                                                                    {".css", "text/css; charset=utf-8"},
                                                                    {".dae", "model/vnd.collada+xml"},
                                                                    {".dds", "image/vnd.ms-dds"},
                                                                    {".gif", "image/gif"},
                                                                    {".glb", "model/gltf-binary"},
                                                                    {".gltf", "model/gltf+json"},
                                                                    {".html", "text/html; charset=utf-8"},
                                                                    {".ico", "image/x-icon"},
                                                                    {".jpeg", "image/jpeg"},
                                                                    {".jpg", "image/jpeg"},
                                                                    {".js", "text/javascript; charset=utf-8"},
                                                                    {".json", "application/json"},
                                                                    {".mtl", "model/mtl"},
                                                                    {".obj", "model/obj"},
                                                                    {".png", "image/png"},
                                                                    {".stl", "model/stl"},
                                                                    {".svg", "image/svg+xml"},
                                                                    {".tga", "image/x-tga"},
                                                                    {".tif", "image/tiff"},
                                                                    {".tiff", "image/tiff"},
                                                                    {".txt", "text/plain; charset=utf-8"},
                                                                    {".wasm", "application/wasm"},
                                                                    {".webp", "image/webp"},
                                                                    {".woff2", "font/woff2"}};

}  // namespace

std::string_view mediaType(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* const found = std::ranges::find(kTypes, extension, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kTypes) ? std::string_view{} : found->second;
}

}  // namespace pongsim::web
