#include "apps/command/command.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/command/compared_runs.hpp"
#include "apps/report/comparison.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/run/run_folder.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/system/files.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/markup.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* report_footer =
    "For one run, its report, pictures, curve and summary are made again from its result.h5, as after a full "
    "disk.\n"
    "Example: two specimens that differ in their random strengths\n"
    "  mesopix simulate specimen.h5 --seed 1 -o runs/one\n"
    "  mesopix simulate specimen.h5 --seed 2 -o runs/two\n"
    "  mesopix report runs/one runs/two -o comparison.html";

/// The folder that a run has written.
fs::path folder_of(const std::string& run) {
  const fs::path result = result_of(run);
  if (result.filename() != "result.h5")
    throw Rejected(Exit::usage, "RUN", run, "must be the folder of a run, or its result.h5");
  return result.has_parent_path() ? result.parent_path() : fs::path(".");
}

void check(const std::vector<std::string>& runs) {
  if (runs.empty())
    throw Rejected(Exit::usage, "RUN", "none given", "must be one run at least",
                   "mesopix report RUN, or RUN RUN to lay two over each other");
}

nlohmann::ordered_json comparison_json(const std::vector<output::ComparedRun>& runs,
                                       const std::vector<output::ComparedSetting>& settings,
                                       const std::string& page) {
  nlohmann::ordered_json json{
      {"files", {page}}, {"runs", nlohmann::json::array()}, {"differences", nlohmann::json::object()}};
  for (const output::ComparedRun& run : runs) {
    nlohmann::ordered_json figures{{"name", run.name}};
    figures.update(nlohmann::ordered_json(output::peak_figures(run.result)));
    figures["tension_failures"] = run.result.tension_failures;
    figures["shear_failures"] = run.result.shear_failures;
    json["runs"].push_back(std::move(figures));
  }
  for (const output::ComparedSetting& setting : settings) json["differences"][setting.key] = setting.values;
  return json;
}

class ReportCommand : public Command {
 public:
  explicit ReportCommand(CLI::App& program)
      : Command(program, "report",
                "Lay several runs over each other on one page, or make the files of one again",
                report_footer) {
    option("RUN", runs_, "folders of runs, or their result.h5", file_form({"h5"}));
    output_ = "comparison.html";
    output_option_ = option("-o,--output", output_, "the page [comparison.html]", file_form({"html"}));
    json_and_quiet("key figures and differences as JSON on standard output");
  }

  Exit run(Console& console) override {
    check(runs_);
    if (runs_.size() == 1) return restore(console);
    const std::vector<output::ComparedRun> compared = read_compared(runs_);
    std::vector<std::string> scenes;
    for (const std::string& run : runs_) scenes.push_back(read_scene_text(result_of(run).string()));
    std::vector<output::ComparedSetting> settings;
    for (SceneDifference& one : scene_differences(scenes))
      settings.push_back({std::move(one.key), std::move(one.values)});
    mpm::replace_file(output_, output::comparison_html(compared, settings));
    if (json_) console.out << json_text(comparison_json(compared, settings, output_));
    console.say("wrote " + output_);
    return Exit::ok;
  }

 private:
  /// The files that a full disk has kept back, or that an earlier part of the run has left.
  [[nodiscard]] Exit restore(Console& console) {
    if (output_option_->count() > 0)
      throw Rejected(Exit::usage, "-o", output_, "is for two runs or more",
                     "the report of a single run is report.html in its folder");
    const fs::path folder = folder_of(runs_.front());
    const HeldFolder held(folder);
    remove_remainders(folder);
    const ReadRun run = read_run(folder.string());
    const RunRecord record = run.record();
    write_run_again(folder, record);
    if (json_) console.out << json_text(summary(record));
    console.say("wrote " + (folder / "report.html").string() + ", and what belongs to it");
    return Exit::ok;
  }

  std::vector<std::string> runs_;
  CLI::Option* output_option_ = nullptr;
};

}  // namespace

CommandPointer report_command(CLI::App& parent) { return std::make_unique<ReportCommand>(parent); }

}  // namespace app
