#include "apps/twin/twinning.hpp"

#include <fmt/format.h>
#include <filesystem>
#include <optional>
#include <utility>

#include "apps/job/specimen_source.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/version.hpp"
#include "specimen/describe/statistics.hpp"
#include "specimen/picture/picture.hpp"

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
  records.resize(run_jobs(jobs, core_count(),
                          {[&](std::size_t done, std::size_t) { made(done); }, [&] { return !stopped(); }}));
  return records;
}

std::vector<specimen::Descriptors> descriptors_of(const std::vector<TwinRecord>& twins) {
  std::vector<specimen::Descriptors> all;
  for (const TwinRecord& twin : twins) all.push_back(twin.descriptors);
  return all;
}

namespace {

QuantityCodec length(Bounds bounds, std::optional<Word> word = {}) {
  return {Dimension::length, bounds, word};
}

/// 0 where none was given.
double optional_length(const char* option, const std::string& text) {
  return text.empty() ? 0 : read_option(option, text, length(above(0)));
}

/// A specimen without inclusions whose labels have aggregate: a file that another program wrote.
void require_inclusions(const specimen::Specimen& original, const std::string& input) {
  if (!original.inclusions.empty() || specimen::count_labels(original.mask)[specimen::phase::aggregate] == 0)
    return;
  throw Rejected(Exit::data, input, "has aggregate but tells of no inclusions", "twins need their outlines",
                 "export its labels as a picture and give that");
}

}  // namespace

specimen::TwinOptions twin_options(const TwinWish& wish) {
  using specimen::Border;
  const ChoiceCodec<Border> border{
      {{"auto", Border::automatic}, {"cut", Border::cut}, {"whole", Border::whole}}};
  specimen::TwinOptions options;
  options.width = optional_length("twin-width", wish.width);
  options.height = optional_length("twin-height", wish.height);
  options.pixel_size = optional_length("twin-pixel-size", wish.pixel_size);
  options.gap = read_option("gap", wish.gap, length(at_least(0), Word{"auto", -1}));
  options.border = read_option("border", wish.border, border);
  return options;
}

TwinTask make_twin_task(const TwinWish& wish, const std::string& input, const Settings& settings,
                        const specimen::ItzOptions& itz, specimen::Specimen original) {
  require_inclusions(original, input);
  TwinTask task;
  task.name = std::filesystem::path(input).stem().string();
  task.count = read_option("count", wish.count, IntegerCodec<>{between(1, 1000)});
  task.seed = read_option("seed", wish.seed, IntegerCodec<std::uint64_t>{at_least(0)});
  task.itz = itz;
  task.settings = settings;
  task.descriptors = specimen::describe(original);
  task.plan = specimen::plan_twins(task.descriptors, twin_options(wish));
  task.original = std::move(original);
  return task;
}

}  // namespace app
