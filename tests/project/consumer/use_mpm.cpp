// Pulls a block of mortar until it breaks, and writes and reads the result: Eigen, HDF5 and the threads do
// their work.
#include <libmpm/files/result_file.hpp>
#include <libmpm/run/simulate.hpp>

#include <cstdint>
#include <optional>

int main() {
  mpm::Scene scene;
  scene.labels = mpm::PixelField<std::uint8_t>::Constant(20, 20, 1);
  scene.pixel_size = 1e-3;
  scene.phases = {std::nullopt, mpm::concrete_phases().at(1)};
  scene.loading.velocity = 0.2;
  scene.threads = 2;
  const mpm::Result result = mpm::simulate(scene);
  if (!(result.peak_stress > 1e5) || result.tension_failures == 0) return 1;
  mpm::write_result("use_mpm.h5", result, "");
  return mpm::read_result("use_mpm.h5").peak_stress == result.peak_stress ? 0 : 2;
}
