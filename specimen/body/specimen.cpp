#include "specimen/body/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>

#include "specimen/body/error.hpp"

namespace specimen {

Specimen make_specimen(Segmented segmented, const ItzOptions& itz, Provenance provenance) {
  if (!(itz.thickness >= 0) || !std::isfinite(itz.thickness))
    throw Error("itz.thickness", millimetres(itz.thickness), "must be >= 0", "0 means one pixel");
  Specimen specimen{
      std::move(segmented.mask), std::move(segmented.inclusions), itz, {}, std::move(provenance)};
  if (itz.mode == ItzMode::none) return specimen;

  specimen.rings.reserve(specimen.inclusions.size());
  constexpr int usual_points = 36;  // they have mass: no more than in the paper, unless asked for
  const int segments = itz.segments == 0 && itz.mode == ItzMode::points ? usual_points : itz.segments;
  for (const Inclusion& inclusion : specimen.inclusions)
    for (Ring& ring : make_rings(inclusion, segments)) specimen.rings.push_back(std::move(ring));
  if (itz.mode == ItzMode::ring) {
    const double thickness = itz.thickness > 0 ? itz.thickness : specimen.mask.pixel_size;
    draw_rings(specimen.mask, segmented.instances, specimen.rings, thickness);
  }
  return specimen;
}

namespace {

using std::to_string;

std::string numbered(const std::string& list, std::size_t index, const std::string& member) {
  return list + "[" + to_string(index) + "]." + member;
}

void check_at_most(const std::string& field, std::int64_t count, std::int64_t limit) {
  if (count > limit) throw Error(field, to_string(count), "must be at most " + to_string(limit));
}

bool all_finite(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

void check_phases(const std::vector<std::string>& phases) {
  if (phases.empty() || phases.size() > 256)
    throw Error("phases", to_string(phases.size()) + " names", "must be 1 to 256");
  std::set<std::string> seen;
  for (const std::string& name : phases) {
    if (name.empty()) throw Error("phases", "an empty name", "every phase needs a name");
    if (!seen.insert(name).second)
      throw Error("phases", "'" + name + "' twice", "every phase needs a unique name");
  }
}

void check_extent(const Raster<std::uint8_t>& labels) {
  const std::string met = to_string(labels.rows) + " x " + to_string(labels.cols) + " pixels";
  if (labels.rows < 1 || labels.cols < 1) throw Error("labels", met, "must be at least 1 x 1");
  const std::int64_t pixels = static_cast<std::int64_t>(labels.rows) * labels.cols;
  if (pixels > max_pixels) throw Error("labels", met, "must be at most " + to_string(max_pixels));
  if (static_cast<std::int64_t>(labels.size()) != pixels)
    throw Error("labels", to_string(labels.size()) + " values", "must be one for each of " + met);
}

void check_mask(const LabelledMask& mask) {
  check_extent(mask.labels);
  if (!(std::isfinite(mask.pixel_size) && mask.pixel_size > 0))
    throw Error("pixel_size", to_string(mask.pixel_size) + " m", "must be > 0");
  check_phases(mask.phases);
  const auto& data = mask.labels.data;
  const auto bad = std::find_if(data.begin(), data.end(),
                                [n = mask.phases.size()](std::uint8_t label) { return label >= n; });
  if (bad == data.end()) return;
  const auto index = bad - data.begin();
  throw Error("labels",
              to_string(*bad) + " at row " + to_string(index / mask.labels.cols) + ", column " +
                  to_string(index % mask.labels.cols),
              "must be below " + to_string(mask.phases.size()) + ", the number of phases");
}

/// A figure of an inclusion and whether it must be above zero.
struct Figure {
  const char* member;
  double value;
  bool positive;
};

void check_inclusion(const Inclusion& inclusion, std::size_t index) {
  const auto field = [index](const char* member) { return numbered("inclusions", index, member); };
  if (inclusion.id < 1) throw Error(field("id"), to_string(inclusion.id), "must be >= 1");
  const Ellipse& e = inclusion.ellipse;
  const Figure figures[] = {{"x", e.x, false},
                            {"y", e.y, false},
                            {"a", e.a, true},
                            {"b", e.b, true},
                            {"angle", e.angle, false},
                            {"area", inclusion.area, true},
                            {"perimeter", inclusion.perimeter, true},
                            {"equivalent_diameter", inclusion.equivalent_diameter, true},
                            {"orientation", inclusion.orientation, false}};
  for (const Figure& figure : figures)
    if (!std::isfinite(figure.value) || (figure.positive && figure.value <= 0))
      throw Error(field(figure.member), to_string(figure.value),
                  figure.positive ? "must be > 0" : "must be a finite number");
  if (!all_finite(inclusion.contour)) throw Error(field("contour"), "not a number", "must be finite numbers");
}

std::unordered_set<int> check_inclusions(const std::vector<Inclusion>& inclusions) {
  check_at_most("inclusions", static_cast<std::int64_t>(inclusions.size()), max_inclusions);
  std::unordered_set<int> ids;
  std::int64_t points = 0;
  for (std::size_t i = 0; i < inclusions.size(); ++i) {
    check_inclusion(inclusions[i], i);
    if (!ids.insert(inclusions[i].id).second)
      throw Error(numbered("inclusions", i, "id"), to_string(inclusions[i].id) + " was used before",
                  "must be a unique id");
    points += static_cast<std::int64_t>(inclusions[i].contour.size());
  }
  check_at_most("contours", points, max_points);
  return ids;
}

void check_itz(const ItzOptions& itz) {
  if (!(std::isfinite(itz.thickness) && itz.thickness >= 0))
    throw Error("itz.thickness", to_string(itz.thickness) + " m", "must be >= 0 (0 = one pixel)");
  if (itz.segments != 0 && itz.segments < 3)
    throw Error("itz.segments", to_string(itz.segments), "must be >= 3, or 0 = automatic");
}

void check_ring(const Ring& ring, std::size_t index, const std::unordered_set<int>& ids) {
  if (!ids.contains(ring.inclusion))
    throw Error(numbered("rings", index, "inclusion"), to_string(ring.inclusion),
                "must be the id of an inclusion");
  const auto field = [index] { return numbered("rings", index, "vertices"); };
  if (ring.vertices.size() < 3)
    throw Error(field(), to_string(ring.vertices.size()) + " corners", "must be >= 3");
  if (!all_finite(ring.vertices)) throw Error(field(), "not a number", "must be finite numbers");
}

void check_rings(const std::vector<Ring>& rings, const std::unordered_set<int>& ids) {
  std::int64_t points = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    check_ring(rings[i], i, ids);
    points += static_cast<std::int64_t>(rings[i].vertices.size());
  }
  check_at_most("rings", points, max_points);
}

}  // namespace

void validate(const Specimen& specimen) {
  check_mask(specimen.mask);
  check_itz(specimen.itz);
  check_rings(specimen.rings, check_inclusions(specimen.inclusions));
}

}  // namespace specimen
