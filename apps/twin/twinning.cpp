#include "apps/twin/twinning.hpp"

#include <fmt/format.h>

#include "apps/system/hdf5_turn.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/text/quantity.hpp"
#include "apps/job/specimen_output.hpp"
#include "apps/text/version.hpp"
#include "specimen/picture/preview.hpp"

namespace app {
namespace {

std::string length_text(double length) { return format_quantity(length, Dimension::length); }

specimen::Provenance provenance_of(const TwinTask& task, std::uint64_t seed) {
  const specimen::Provenance& original = task.original.provenance;
  const specimen::TwinPlan& plan = task.plan;
  return {
      "twin of " + original.source, original.sha256,
      fmt::format("{}\n# A twin of it: seed {}, {} x {}, pixels of {}, gap {}, {} border, {} directions.\n",
                  original.options, seed, length_text(plan.width), length_text(plan.height),
                  length_text(plan.pixel_size), length_text(plan.gap), plan.cut ? "cut" : "whole",
                  plan.oriented ? "the original's" : "random"),
      seed, version()};
}

}  // namespace

std::string twin_file(int number) { return fmt::format("twin_{:03}.h5", number); }

std::vector<TwinRecord> make_twins(const TwinTask& task, const std::filesystem::path& folder,
                                   const std::function<bool()>& stopped,
                                   const std::function<void(std::size_t)>& made) {
  std::vector<TwinRecord> records(static_cast<std::size_t>(task.count));
  std::vector<std::function<void()>> jobs;
  for (std::size_t i = 0; i < records.size(); ++i)
    jobs.emplace_back([&, i] {
      const std::uint64_t seed = task.seed + i;
      specimen::Twin twin = specimen::draw_twin(task.plan, seed);
      const specimen::Specimen specimen =
          specimen::make_specimen(std::move(twin.segmented), task.itz, provenance_of(task, seed));
      records[i] = {
          seed, twin_file(static_cast<int>(i) + 1), specimen::describe(specimen), twin.relaxed, twin.lost,
          {}};
      if (i < pictured_twins) records[i].picture = specimen::preview(specimen.mask);
      const Hdf5Turn turn = hdf5_turn();
      (void)write_specimen_output((folder / records[i].file).string(), specimen);
    });
  records.resize(run_jobs(jobs, core_count(), {made, [&] { return !stopped(); }}));
  return records;
}

std::vector<specimen::Descriptors> descriptors_of(const std::vector<TwinRecord>& twins) {
  std::vector<specimen::Descriptors> all;
  for (const TwinRecord& twin : twins) all.push_back(twin.descriptors);
  return all;
}

}  // namespace app
