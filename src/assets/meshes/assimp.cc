#include "assets/meshes/assimp.hh"

#include "base/shared_library.hh"

namespace pongsim::assets {

namespace {

Assimp openAssimp() {
  const auto library = base::SharedLibrary::require(PONGSIM_ASSIMP, "libassimp5");
  Assimp functions{};
  library.bind(functions.createPropertyStore, "aiCreatePropertyStore");
  library.bind(functions.setImportPropertyInteger, "aiSetImportPropertyInteger");
  library.bind(functions.releasePropertyStore, "aiReleasePropertyStore");
  library.bind(functions.importFileExWithProperties, "aiImportFileExWithProperties");
  library.bind(functions.importFileFromMemoryWithProperties, "aiImportFileFromMemoryWithProperties");
  library.bind(functions.releaseImport, "aiReleaseImport");
  library.bind(functions.getErrorString, "aiGetErrorString");
  library.bind(functions.getMaterialColor, "aiGetMaterialColor");
  library.bind(functions.getMaterialString, "aiGetMaterialString");
  library.bind(functions.getMaterialTexture, "aiGetMaterialTexture");
  return functions;
}

}  // namespace

const Assimp& assimp() {
  static const Assimp functions = openAssimp();
  return functions;
}

}  // namespace pongsim::assets
