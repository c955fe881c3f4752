// Packs and draws ellipses, takes the picture of them for that of a stranger, and writes and reads the
// specimen that comes of it: PNG, OpenCV and HDF5 are linked and do their work.
#include <specimen/body/specimen.hpp>
#include <specimen/convert/convert.hpp>
#include <specimen/file/specimen_file.hpp>
#include <specimen/pack/packing.hpp>
#include <specimen/picture/picture.hpp>

#include <utility>

int main() {
  specimen::PackingOptions wanted;
  wanted.width = wanted.height = 0.05;
  wanted.fraction = 0.3;
  wanted.grading = specimen::named_grading("fuller", 4e-3, 10e-3);
  const auto drawn = specimen::draw_ellipses(specimen::pack(wanted).ellipses, 0.05, 0.05, 0.5e-3);
  specimen::write_png("use_specimen.png", specimen::preview(drawn.mask), 0.5e-3);

  auto converted = specimen::convert_picture("use_specimen.png", {});
  const auto made = specimen::make_specimen(std::move(converted.segmented), {}, {});
  if (made.inclusions.empty() || made.inclusions.size() != made.rings.size()) return 1;
  specimen::write_specimen("use_specimen.h5", made);
  return specimen::read_specimen("use_specimen.h5").mask == made.mask ? 0 : 2;
}
