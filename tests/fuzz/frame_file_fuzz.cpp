// Any file as a frame of a run: there is a frame, or a FileError.
#include "libmpm/files/frame_file.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/fuzz/hdf5_edits.hpp"
#include "tests/libmpm/sample_frames.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Hdf5Sample sample = fuzz::hdf5_sample([](const std::string& path) {
    mpm::write_frame(path, samples::odd_frame(), samples::mortar_block(2, 2));
  });
  fuzz::read_hdf5_input(sample, data, size, [](const std::string& path) {
    try {
      (void)mpm::read_frame_heading(path);
      (void)mpm::read_frame(path);
    } catch (const mpm::FileError&) {
      // refused, as it may be
    }
  });
  return 0;
}
