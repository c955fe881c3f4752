// Any picture as a specimen: there is a valid specimen, or an Error.
#include "specimen/body/error.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/convert/convert.hpp"
#include "tests/fuzz/input_file.hpp"

namespace {

specimen::ConvertOptions options() {
  specimen::ConvertOptions options;
  options.source_pixel_size = 1e-3;
  options.max_pixels = 1 << 10;
  return options;
}

void convert(const std::string& path) {
  specimen::Converted converted = specimen::convert_picture(path, options());
  specimen::validate(specimen::make_specimen(std::move(converted.segmented), {}, {}));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file;
  try {
    convert(file.hold(data, size));
  } catch (const specimen::Error&) {
    // refused, as it may be
  }
  return 0;
}
