// Writes the folder of a run that was never computed, for the check of its page and for the eye:
//   write_sample_run FOLDER [tension|compression|impact|short|hostile] [PIXELS]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "apps/run/run_folder.hpp"
#include "tests/apps/fake_run.hpp"

int main(int argc, char** argv) {
  if (argc < 2) return 64;
  const std::string kind = argc > 2 ? argv[2] : "tension";
  const int pixels = argc > 3 ? std::atoi(argv[3]) : 300;
  const FakeRun run = kind == "compression" ? compression_run(pixels)
                      : kind == "impact"    ? impact_run(pixels)
                                            : tension_run(pixels, kind == "short" ? 20 : 280);
  RunRecord record = run.record();
  if (kind == "compression" || kind == "impact") record.title = "";
  if (kind == "hostile") {
    record.title = "</script><script>alert(1)</script>";
    record.scene_toml = "</pre></details><img src=x onerror=alert(1)> & \x01 \xff\xfe";
    record.notes = {"\"><svg onload='alert(1)'>"};
  }
  const auto start = std::chrono::steady_clock::now();
  write_run(argv[1], record);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::printf("%s: %.3f s\n", argv[1], taken.count());
  return 0;
}
