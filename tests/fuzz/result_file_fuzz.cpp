// Any file as the result of a run: there is a result, or a FileError.
#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/fuzz/hdf5_edits.hpp"
#include "tests/libmpm/sample_results.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Hdf5Sample sample = fuzz::hdf5_sample(
      [](const std::string& path) { mpm::write_result(path, samples::odd_result(), "[loading]\n"); });
  fuzz::read_hdf5_input(sample, data, size, [](const std::string& path) {
    try {
      (void)mpm::read_scene_text(path);
      (void)mpm::read_result(path);
    } catch (const mpm::FileError&) {
      // refused, as it may be
    }
  });
  return 0;
}
