// Any file as a specimen: there is a valid specimen, or an Error.
#include "specimen/body/error.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/file/specimen_file.hpp"
#include "tests/fuzz/hdf5_edits.hpp"
#include "tests/specimen/sample_specimen.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Hdf5Sample sample = fuzz::hdf5_sample(
      [](const std::string& path) { specimen::write_specimen(path, test::sample_specimen()); });
  fuzz::read_hdf5_input(sample, data, size, [](const std::string& path) {
    try {
      specimen::validate(specimen::read_specimen(path));
    } catch (const specimen::Error&) {
      // refused, as it may be
    }
  });
  return 0;
}
