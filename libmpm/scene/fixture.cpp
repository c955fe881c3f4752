#include "libmpm/scene/fixture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

std::string numbered(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index + 1) + "]";
}

void check_stretch(Faults& faults, const std::string& field, const Stretch& at, const Scene& scene) {
  const bool level = at.side == Side::bottom || at.side == Side::top;
  const double length = level ? scene.width() : scene.height();
  faults.require(std::isfinite(at.from) && at.from >= 0, field + ".from", text(1e3 * at.from, "mm"),
                 "must be >= 0 mm");
  faults.require(at.to >= at.from, field + ".to", text(1e3 * at.to, "mm"),
                 "must not be less than from = " + text(1e3 * at.from, "mm"));
  if (length > 0)
    faults.require(!(at.from > length * (1 + 1e-9)), field + ".from", text(1e3 * at.from, "mm"),
                   "must be no more than the side is long, " + text(1e3 * length, "mm"));
}

void check_loads(Faults& faults, const Scene& scene) {
  const auto& loads = scene.fixture.loads;
  const auto leading = std::count_if(loads.begin(), loads.end(), [](const Load& load) { return load.leads; });
  faults.require(leading == 1, "loads", std::to_string(leading) + " of them lead", "exactly one load leads",
                 "write leads = true for the one whose displacement is given");
  for (std::size_t i = 0; i < loads.size(); ++i) {
    check_stretch(faults, numbered("loads", i), loads[i].at, scene);
    faults.require(std::isfinite(loads[i].share) && loads[i].share != 0, numbered("loads", i) + ".share",
                   text(loads[i].share, ""), "must be a number other than 0");
    if (loads[i].leads)
      faults.require(loads[i].share == 1, numbered("loads", i) + ".share", text(loads[i].share, ""),
                     "must be 1 for the load that leads");
  }
}

void check_gauge(Faults& faults, const std::string& field, const Gauge& gauge) {
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  faults.require(!gauge.name.empty() && std::all_of(gauge.name.begin(), gauge.name.end(), is_letter),
                 field + ".name", gauge.name, "must be letters, digits, _ and -");
  const bool finite = std::isfinite(gauge.x1 + gauge.y1 + gauge.x2 + gauge.y2);
  faults.require(finite && std::hypot(gauge.x2 - gauge.x1, gauge.y2 - gauge.y1) > 0, field + ".between",
                 "both points at one place", "must be two points");
  if (gauge.until)
    faults.require(std::isfinite(*gauge.until) && *gauge.until > 0, field + ".until",
                   text(1e3 * *gauge.until, "mm"), "must be > 0 mm");
}

void check_gauges(Faults& faults, const Scene& scene) {
  const auto& gauges = scene.fixture.gauges;
  for (std::size_t i = 0; i < gauges.size(); ++i) {
    check_gauge(faults, numbered("gauges", i), gauges[i]);
    for (std::size_t j = 0; j < i; ++j)
      faults.require(gauges[i].name != gauges[j].name, numbered("gauges", i) + ".name", gauges[i].name,
                     "is the name of an earlier gauge", "give each gauge its own");
  }
  const auto controlling =
      std::count_if(gauges.begin(), gauges.end(), [](const Gauge& gauge) { return gauge.controls; });
  faults.require(controlling <= 1, "gauges", std::to_string(controlling) + " of them control",
                 "at most one gauge controls a run", "remove controls from the others");
  faults.require(controlling == 0 || scene.loading.path == LoadingPath::strain, "loading.path", "snap_back",
                 "follows every point to its failure, and leaves nothing to a gauge that controls",
                 "remove controls of the gauge, or choose loading.path = \"strain\"");
}

}  // namespace

std::vector<Error> fixture_faults(const Scene& scene) {
  const Fixture& fixture = scene.fixture;
  Faults faults;
  faults.require(std::isfinite(fixture.thickness) && fixture.thickness > 0, "loading.thickness",
                 text(1e3 * fixture.thickness, "mm"), "must be > 0 mm");
  if (fixture.supports.empty() && fixture.loads.empty() && fixture.gauges.empty())
    return std::move(faults).found();
  const char* list = !fixture.loads.empty() ? "loads" : !fixture.gauges.empty() ? "gauges" : "supports";
  faults.require(scene.kinematics == Kinematics::small_strain, list, "with points that move",
                 "are for points that keep their place", "choose solver.kinematics = \"small_strain\"");
  faults.require(scene.method == SolverMethod::quasi_static, list, "with inertia",
                 "are for runs without inertia", "choose solver.method = \"quasi_static\"");
  faults.require(fixture.supports.empty() || fixture.has_loads(), "supports", "without loads",
                 "take the place of the platens, and then something must move",
                 "add [[loads]], or remove the supports");
  if (fixture.has_loads()) {
    faults.require(scene.loading.direction == Direction::tension, "loading.direction", "given beside loads",
                   "has no effect: the way of a load says where it goes", "remove it");
    check_loads(faults, scene);
  }
  for (std::size_t i = 0; i < fixture.supports.size(); ++i) {
    check_stretch(faults, numbered("supports", i), fixture.supports[i].at, scene);
    faults.require(fixture.supports[i].fix_x || fixture.supports[i].fix_y, numbered("supports", i) + ".fix",
                   "nothing", "must be x, y or xy");
  }
  check_gauges(faults, scene);
  return std::move(faults).found();
}

}  // namespace mpm
