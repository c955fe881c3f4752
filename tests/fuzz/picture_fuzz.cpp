// Any bytes as a picture: there is a picture of the size that was allowed, or an Error.
#include <cstdlib>

#include "specimen/body/error.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/fuzz/input_file.hpp"
#include "tests/fuzz/png_checksums.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  size = LLVMFuzzerMutate(data, size, max_size);
  if (seed % 8 != 0) fuzz::correct_png_checksums(data, size);
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file;
  constexpr std::int64_t most = 1 << 16;
  try {
    const specimen::Picture picture = specimen::read_picture(file.hold(data, size), most);
    const std::int64_t pixels = std::int64_t{picture.rows()} * picture.cols();
    if (pixels < 1 || pixels > most) std::abort();
  } catch (const specimen::Error&) {
    // refused, as it may be
  }
  return 0;
}
