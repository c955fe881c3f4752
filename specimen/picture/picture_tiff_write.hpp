/// libtiff without output on the terminal and with bounded memory, for the reader and the writer of TIFF.
#pragma once

#include <tiffio.h>

#include <array>
#include <memory>

namespace specimen {

/// Largest single allocation of libtiff [bytes].
inline constexpr tmsize_t largest_allocation = tmsize_t{1} << 30;

struct TiffMessages {
  std::array<char, 200> text{};  ///< of the first error
};

struct TiffDeleter {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using TiffHandle = std::unique_ptr<TIFF, TiffDeleter>;
using TiffOptions = std::unique_ptr<TIFFOpenOptions, TiffDeleter>;

/// Options under which a file is opened; the messages must outlive the handle, since closing may still
/// report.
[[nodiscard]] TiffOptions quiet_options(TiffMessages& messages);

}  // namespace specimen
