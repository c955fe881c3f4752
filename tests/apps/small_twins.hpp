/// Two twins that are made in no time.
#pragma once

#include "apps/twin/twinning.hpp"
#include "specimen/pack/packing.hpp"

namespace test {

/// Of a generated specimen of 40 mm x 40 mm with 80 x 80 pixels.
inline app::TwinTask small_task() {
  specimen::PackingOptions options;
  options.width = options.height = 0.04;
  options.fraction = 0.4;
  options.grading = specimen::named_grading("fuller", 4e-3, 10e-3);
  app::TwinTask task;
  task.name = "cut";
  task.original = specimen::make_specimen(
      specimen::draw_ellipses(specimen::pack(options).ellipses, options.width, options.height, 0.5e-3), {},
      {"cut.png", std::string(64, 'a'), "# options of the original\n", 0, "0"});
  task.descriptors = specimen::describe(task.original);
  task.plan = specimen::plan_twins(task.descriptors, {});
  task.seed = 5;
  task.count = 2;
  return task;
}

/// Twins of it, without files.
inline std::vector<app::TwinRecord> small_twins(const app::TwinTask& task) {
  std::vector<app::TwinRecord> twins;
  for (int i = 0; i < task.count; ++i) {
    const std::uint64_t seed = task.seed + static_cast<std::uint64_t>(i);
    specimen::Twin twin = specimen::draw_twin(task.plan, seed);
    twins.push_back({seed, app::twin_file(i + 1),
                     specimen::describe(specimen::make_specimen(std::move(twin.segmented), task.itz, {})),
                     twin.relaxed, twin.lost});
  }
  return twins;
}

}  // namespace test
