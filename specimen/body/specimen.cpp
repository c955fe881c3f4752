#include "specimen/body/specimen.hpp"

#include <cmath>
#include <utility>

#include "specimen/body/error.hpp"
#include "specimen/body/wording.hpp"

namespace specimen {

Specimen make_specimen(Segmented segmented, const ItzOptions& itz, Provenance provenance) {
  if (!(itz.thickness >= 0) || !std::isfinite(itz.thickness))
    throw Error("itz.thickness", millimetres(itz.thickness), "must be >= 0", "0 means one pixel");
  Specimen specimen{
      std::move(segmented.mask), std::move(segmented.inclusions), itz, {}, std::move(provenance)};
  if (itz.mode == ItzMode::none) return specimen;

  specimen.rings.reserve(specimen.inclusions.size());
  for (const Inclusion& inclusion : specimen.inclusions)
    specimen.rings.push_back(make_ring(inclusion, itz.segments));
  if (itz.mode == ItzMode::ring) {
    const double thickness = itz.thickness > 0 ? itz.thickness : specimen.mask.pixel_size;
    draw_rings(specimen.mask, segmented.instances, specimen.rings, thickness);
  }
  return specimen;
}

}  // namespace specimen
