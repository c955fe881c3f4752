#include "libmpm/problems/method.hpp"

namespace mpm::problems {

std::string Method::name() const {
  const char* shapes[] = {"linear", "GIMP", "B-spline"};
  const char* schemes[] = {"USF", "USL", "MUSL"};
  const char* back = transfer == Transfer::apic ? "APIC"
                     : flip_ratio <= 0          ? "PIC"
                     : flip_ratio < 1           ? "blend"
                                                : "FLIP";
  return std::string(shapes[static_cast<int>(shape)]) + " " + schemes[static_cast<int>(scheme)] + " " + back +
         (precision == Precision::single ? " single" : "");
}

void Method::give_to(Scene& scene) const {
  scene.motion.shape = shape;
  scene.motion.scheme = scheme;
  scene.motion.transfer = transfer;
  scene.motion.flip_ratio = flip_ratio;
  scene.precision = precision;
}

const std::vector<Shape>& all_shapes() {
  static const std::vector<Shape> shapes{Shape::linear, Shape::gimp, Shape::bspline};
  return shapes;
}

std::vector<Method> all_methods(double blend) {
  std::vector<Method> methods;
  for (const auto shape : all_shapes())
    for (const auto scheme : {Scheme::usf, Scheme::usl, Scheme::musl}) {
      methods.push_back({shape, scheme, Transfer::flip, 1});
      methods.push_back({shape, scheme, Transfer::flip, blend});
      methods.push_back({shape, scheme, Transfer::apic, 1});
    }
  return methods;
}

}  // namespace mpm::problems
