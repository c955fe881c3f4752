#include "specimen/pack/canvas.hpp"

#include <cmath>
#include <cstdint>

#include "specimen/body/error.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace {

// A millionth of a pixel: what is lost by writing numbers in decimals is no user's mistake.
constexpr double pixel_tolerance = 1e-6;

int whole_pixels(const std::string& field, double size, double pixel_size) {
  if (!(size > 0) || !std::isfinite(size)) throw Error(field, millimetres(size), "must be > 0");
  constexpr double most = 100'000;
  const double pixels = size / pixel_size, whole = std::round(pixels);
  if (pixels > most) {
    throw Error(field, millimetres(size),
                "is " + number(pixels) + " pixels of " + millimetres(pixel_size) + "; at most " +
                    number(most) + " are allowed",
                "raise the pixel size");
  }
  if (whole < 1 || std::abs(pixels - whole) > pixel_tolerance) {
    const double below = std::floor(pixels), above = below + 1;
    throw Error(field, millimetres(size), "must be a whole number of pixels of " + millimetres(pixel_size),
                "take " + (below > 0 ? millimetres(below * pixel_size) + " or " : "") +
                    millimetres(above * pixel_size));
  }
  return static_cast<int>(whole);
}

}  // namespace

std::vector<Error> canvas_faults(double width, double height, double pixel_size, const std::string& group) {
  std::vector<Error> faults;
  const auto look_at = [&](double across, double up) {
    try {
      (void)canvas_of(across, up, pixel_size, group);
    } catch (const Error& fault) {
      if (faults.empty() || faults.front().field != fault.field) faults.push_back(fault);
    }
  };
  look_at(width, pixel_size);
  look_at(pixel_size, height);
  if (faults.empty()) look_at(width, height);
  return faults;
}

Canvas canvas_of(double width, double height, double pixel_size, const std::string& group) {
  if (!(pixel_size > 0) || !std::isfinite(pixel_size))
    throw Error(group + ".pixel_size", millimetres(pixel_size), "must be > 0");
  const int cols = whole_pixels(group + ".width", width, pixel_size);
  const int rows = whole_pixels(group + ".height", height, pixel_size);
  if (std::int64_t{rows} * cols > max_pixels) {
    throw Error(group + ".pixel_size", millimetres(pixel_size),
                "makes " + std::to_string(cols) + " x " + std::to_string(rows) + " pixels; at most " +
                    number(static_cast<double>(max_pixels)) + " are allowed",
                "raise the pixel size");
  }
  return {rows, cols};
}

}  // namespace specimen
