#pragma once

#include <assimp/cimport.h>
#include <assimp/scene.h>

namespace pongsim::assets {

/// What is used of Assimp's functions, by their names without `ai`. Its library is opened with the first mesh file:
/// only worlds with meshes need it, and every command would wait for it.
struct Assimp {
  decltype(&aiCreatePropertyStore) createPropertyStore;
  decltype(&aiSetImportPropertyInteger) setImportPropertyInteger;
  decltype(&aiReleasePropertyStore) releasePropertyStore;
  decltype(&aiImportFileExWithProperties) importFileExWithProperties;
  decltype(&aiReleaseImport) releaseImport;
  decltype(&aiGetErrorString) getErrorString;
};

/// @throws std::runtime_error where its library can't be opened, saying what to install.
const Assimp& assimp();

}  // namespace pongsim::assets
