#pragma once

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/scene.h>

namespace pongsim::assets {

/// The functions of Assimp in use, without the prefix `ai`. The library is opened for the first mesh file: only worlds
/// with meshes need it, and loading it would delay every command.
struct Assimp {
  decltype(&aiCreatePropertyStore) createPropertyStore;
  decltype(&aiSetImportPropertyInteger) setImportPropertyInteger;
  decltype(&aiReleasePropertyStore) releasePropertyStore;
  decltype(&aiImportFileExWithProperties) importFileExWithProperties;
  decltype(&aiImportFileFromMemoryWithProperties) importFileFromMemoryWithProperties;
  decltype(&aiReleaseImport) releaseImport;
  decltype(&aiGetErrorString) getErrorString;
  decltype(&aiGetMaterialColor) getMaterialColor;
  decltype(&aiGetMaterialString) getMaterialString;
  decltype(&aiGetMaterialTexture) getMaterialTexture;
};

/// @throws std::runtime_error if the library can't be opened, with what to install.
const Assimp& assimp();

}  // namespace pongsim::assets
