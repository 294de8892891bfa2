#include "assets/images/tiff.hh"

#include "base/shared_library.hh"

namespace pongsim::assets {

namespace {

TiffLibrary openTiff() {
  const auto library = base::SharedLibrary::require(PONGSIM_TIFF, "libtiff6");
  TiffLibrary functions{};
  library.bind(functions.clientOpenExt, "TIFFClientOpenExt");
  library.bind(functions.close, "TIFFClose");
  library.bind(functions.getField, "TIFFGetField");
  library.bind(functions.getFieldDefaulted, "TIFFGetFieldDefaulted");
  library.bind(functions.isTiled, "TIFFIsTiled");
  library.bind(functions.openOptionsAlloc, "TIFFOpenOptionsAlloc");
  library.bind(functions.openOptionsFree, "TIFFOpenOptionsFree");
  library.bind(functions.openOptionsSetErrorHandlerExtR, "TIFFOpenOptionsSetErrorHandlerExtR");
  library.bind(functions.openOptionsSetMaxSingleMemAlloc, "TIFFOpenOptionsSetMaxSingleMemAlloc");
  library.bind(functions.openOptionsSetWarningHandlerExtR, "TIFFOpenOptionsSetWarningHandlerExtR");
  library.bind(functions.readRGBAImageOriented, "TIFFReadRGBAImageOriented");
  library.bind(functions.readScanline, "TIFFReadScanline");
  library.bind(functions.readTile, "TIFFReadTile");
  library.bind(functions.scanlineSize, "TIFFScanlineSize");
  library.bind(functions.tileSize, "TIFFTileSize");
  return functions;
}

}  // namespace

const TiffLibrary& tiffLibrary() {
  static const TiffLibrary functions = openTiff();
  return functions;
}

}  // namespace pongsim::assets
