#include "apps/command/command.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/report/comparison.hpp"
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

/// The result of a run that was named by its folder, or by the file itself.
fs::path result_of(const std::string& run) {
  switch (kind_of_input(run)) {
    case InputKind::folder:
      return fs::path(run) / "result.h5";
    case InputKind::hdf5:
      return run;
    default:
      throw Rejected(Exit::usage, "RUN", run, "must be the folder of a run, or its result.h5");
  }
}

/// The folder that a run has written.
fs::path folder_of(const std::string& run) {
  const fs::path result = result_of(run);
  if (result.filename() != "result.h5")
    throw Rejected(Exit::usage, "RUN", run, "must be the folder of a run, or its result.h5");
  return result.has_parent_path() ? result.parent_path() : fs::path(".");
}

/// The folder of each run by its last part; the whole path where that is not enough to tell them apart.
std::vector<std::string> names_of(const std::vector<std::string>& runs) {
  std::vector<std::string> names;
  for (const std::string& run : runs) {
    const fs::path folder = fs::absolute(result_of(run)).lexically_normal().parent_path();
    names.push_back(folder.filename().string());
  }
  const std::vector<std::string> short_names = names;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (std::count(short_names.begin(), short_names.end(), short_names[i]) > 1) names[i] = runs[i];
  return names;
}

void check(const std::vector<std::string>& runs) {
  if (runs.empty())
    throw Rejected(Exit::usage, "RUN", "none given", "must be one run at least",
                   "mesopix report RUN, or RUN RUN to lay two over each other");
  if (runs.size() > output::most_compared_runs)
    throw Rejected(Exit::usage, "RUN", std::to_string(runs.size()) + " given",
                   "must be " + std::to_string(output::most_compared_runs) +
                       " runs at most: more lines cannot be told apart");
  for (const std::string& run : runs)
    if (std::count(runs.begin(), runs.end(), run) > 1)
      throw Rejected(Exit::usage, "RUN", run, "must not be given twice");
}

nlohmann::ordered_json comparison_json(const std::vector<output::ComparedRun>& runs,
                                       const std::vector<output::ComparedSetting>& settings,
                                       const std::string& page) {
  nlohmann::ordered_json json{
      {"files", {page}}, {"runs", nlohmann::json::array()}, {"differences", nlohmann::json::object()}};
  for (const output::ComparedRun& run : runs)
    json["runs"].push_back({{"name", run.name},
                            {"peak_stress_Pa", run.result.peak_stress},
                            {"peak_strain", run.result.peak_strain},
                            {"peak_reached", mpm::peak_reached(run.result)},
                            {"tension_failures", run.result.tension_failures},
                            {"shear_failures", run.result.shear_failures}});
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
    const std::vector<std::string> names = names_of(runs_);
    std::vector<output::ComparedRun> compared;
    std::vector<std::string> scenes;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const std::string path = result_of(runs_[i]).string();
      if (fs::path(path).filename() == "result.h5") check_one_run(fs::path(path).parent_path().string());
      compared.push_back({names[i], read_result(path)});
      scenes.push_back(read_scene_text(path));
    }
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
