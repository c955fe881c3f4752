#include "apps/command/command.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/report/comparison.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/markup.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* report_footer =
    "The report of a single run is report.html in its folder.\n"
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
  if (runs.size() < 2)
    throw Rejected(Exit::usage, "RUN", std::to_string(runs.size()) + " given", "must be two runs at least",
                   "the report of a single run is report.html in its folder");
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
      : Command(program, "report", "Lay several runs over each other on one page", report_footer) {
    option("RUN", runs_, "folders of runs, or their result.h5", file_form({"h5"}));
    output_ = "comparison.html";
    option("-o,--output", output_, "the page [comparison.html]", file_form({"html"}));
    json_and_quiet("key figures and differences as JSON on standard output");
  }

  Exit run(Console& console) override {
    check(runs_);
    const std::vector<std::string> names = names_of(runs_);
    std::vector<output::ComparedRun> compared;
    std::vector<std::string> scenes;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const std::string path = result_of(runs_[i]).string();
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
  std::vector<std::string> runs_;
};

}  // namespace

CommandPointer report_command(CLI::App& parent) { return std::make_unique<ReportCommand>(parent); }

}  // namespace app
