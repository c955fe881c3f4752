#include "apps/drawing/stress_component.hpp"

#include <algorithm>
#include <cmath>

namespace output {
namespace {

/// sqrt(3 J2).
double mises(const mpm::FramePoint& p) {
  const double xy = p.sxx - p.syy, yz = p.syy - p.szz, zx = p.szz - p.sxx;
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * p.sxy * p.sxy);
}

}  // namespace

double stress_of(const mpm::FramePoint& p, StressComponent component) {
  const double centre = (p.sxx + p.syy) / 2;
  const double radius = std::hypot((p.sxx - p.syy) / 2, p.sxy);
  switch (component) {
    case StressComponent::yy:
      return p.syy;
    case StressComponent::xx:
      return p.sxx;
    case StressComponent::xy:
      return p.sxy;
    case StressComponent::first:
      return std::max(centre + radius, p.szz);
    case StressComponent::third:
      return std::min(centre - radius, p.szz);
    case StressComponent::mises:
      return mises(p);
  }
  return 0;
}

std::string phrase_of(StressComponent component, bool loaded) {
  switch (component) {
    case StressComponent::yy:
      return loaded ? "stress in the direction of loading" : "vertical stress";
    case StressComponent::xx:
      return loaded ? "stress across the direction of loading" : "horizontal stress";
    case StressComponent::xy:
      return "shear stress";
    case StressComponent::first:
      return "largest principal stress";
    case StressComponent::third:
      return "smallest principal stress";
    case StressComponent::mises:
      return "von Mises stress";
  }
  return {};
}

}  // namespace output
