// Writes and reads a specimen, and has a scene refused: both libraries are linked and do their work.
#include <libmpm/error.hpp>
#include <libmpm/scene.hpp>
#include <specimen/specimen_file.hpp>

int main() {
  specimen::Specimen made;
  made.mask.pixel_size = 1e-3;
  made.mask.labels = specimen::Raster<std::uint8_t>(2, 3, specimen::phase::mortar);
  specimen::write_specimen("consumer.h5", made);
  if (specimen::read_specimen("consumer.h5").mask != made.mask) return 1;
  try {
    mpm::validate(mpm::Scene{});
  } catch (const mpm::Error& error) {
    return error.field.empty() ? 2 : 0;
  }
  return 3;
}
