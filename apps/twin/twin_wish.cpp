#include "apps/twin/twin_wish.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include "apps/settings/read_option.hpp"
#include "specimen/describe/statistics.hpp"

namespace app {
namespace {

Quantity length(Bounds bounds, std::optional<Word> word = {}) { return {Dimension::length, bounds, word}; }

/// 0 where none was given.
double optional_length(const char* option, const std::string& text) {
  return text.empty() ? 0 : read_option(option, text, length(above(0)));
}

/// A specimen without inclusions whose labels have aggregate: a file that another program wrote.
void require_inclusions(const specimen::Specimen& original, const std::string& input) {
  if (!original.inclusions.empty() || specimen::count_labels(original.mask)[specimen::phase::aggregate] == 0)
    return;
  throw Rejected(Exit::data,
                 complaint(input, "has aggregate but tells of no inclusions", "twins need their outlines",
                           "export its labels as a picture and give that"));
}

}  // namespace

specimen::TwinOptions twin_options(const TwinWish& wish) {
  using specimen::Border;
  const Choice<Border> border{{{"auto", Border::automatic}, {"cut", Border::cut}, {"whole", Border::whole}}};
  specimen::TwinOptions options;
  options.width = optional_length("--twin-width", wish.width);
  options.height = optional_length("--twin-height", wish.height);
  options.pixel_size = optional_length("--twin-pixel-size", wish.pixel_size);
  options.gap = read_option("--gap", wish.gap, length(at_least(0), Word{"auto", -1}));
  options.border = read_option("--border", wish.border, border);
  return options;
}

TwinTask make_twin_task(const TwinWish& wish, const std::string& input, const Settings& settings,
                        const specimen::ItzOptions& itz, specimen::Specimen original) {
  require_inclusions(original, input);
  TwinTask task;
  task.name = std::filesystem::path(input).stem().string();
  task.count = read_option("--count", wish.count, Integer<>{{between(1, 1000), {}}});
  task.seed = read_option("--seed", wish.seed, Integer<std::uint64_t>{{at_least(0), {}}});
  task.itz = itz;
  task.settings = settings;
  task.descriptors = specimen::describe(original);
  task.plan = specimen::plan_twins(task.descriptors, twin_options(wish));
  task.original = std::move(original);
  return task;
}

}  // namespace app
