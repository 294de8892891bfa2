#pragma once

#include <tiffio.h>

namespace pongsim::assets {

/// The functions of libtiff in use, without the prefix `TIFF`. The library is opened for the first TIFF file: few
/// worlds have one, and loading it with the seven libraries that it needs would delay every command.
struct TiffLibrary {
  decltype(&TIFFClientOpenExt) clientOpenExt;
  decltype(&TIFFClose) close;
  decltype(&TIFFGetField) getField;
  decltype(&TIFFGetFieldDefaulted) getFieldDefaulted;
  decltype(&TIFFIsTiled) isTiled;
  decltype(&TIFFOpenOptionsAlloc) openOptionsAlloc;
  decltype(&TIFFOpenOptionsFree) openOptionsFree;
  decltype(&TIFFOpenOptionsSetErrorHandlerExtR) openOptionsSetErrorHandlerExtR;
  decltype(&TIFFOpenOptionsSetMaxSingleMemAlloc) openOptionsSetMaxSingleMemAlloc;
  decltype(&TIFFOpenOptionsSetWarningHandlerExtR) openOptionsSetWarningHandlerExtR;
  decltype(&TIFFReadRGBAImageOriented) readRGBAImageOriented;
  decltype(&TIFFReadScanline) readScanline;
  decltype(&TIFFReadTile) readTile;
  decltype(&TIFFScanlineSize) scanlineSize;
  decltype(&TIFFTileSize) tileSize;
};

/// @throws std::runtime_error if the library can't be opened, with what to install.
const TiffLibrary& tiffLibrary();

}  // namespace pongsim::assets
