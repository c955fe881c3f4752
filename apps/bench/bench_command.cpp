#include "apps/bench/bench_command.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/bench/error_study.hpp"
#include "apps/bench/feature_study.hpp"
#include "apps/bench/problem_table.hpp"
#include "apps/bench/stability.hpp"
#include "apps/run/run_location.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/system/processes.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app::bench {
namespace {

using Json = nlohmann::ordered_json;

Json sample_json(const ProblemResult& result, const MethodResult& method, const Sample& sample) {
  return {{"problem", result.problem.name},
          {"method", method.method->name},
          {"refined", method.method->refined},
          {"size", sample.size},
          {"unit", method.method->unit},
          {"error", sample.error},
          {"wall_time_s", sample.wall_time},
          {"point_updates", sample.point_updates},
          {"order", method.order},
          {"front", sample.in_front},
          {"trouble", sample.trouble}};
}

}  // namespace

Json error_json(const std::vector<ProblemResult>& results) {
  Json samples = Json::array();
  for (const ProblemResult& result : results)
    for (const MethodResult& method : result.methods)
      for (const Sample& sample : method.samples) samples.push_back(sample_json(result, method, sample));
  return samples;
}

Json stability_json(const StabilityOutcome& outcome) {
  Json cases = Json::array();
  for (const StabilityRow& row : outcome.rows)
    cases.push_back({{"name", row.name},
                     {"group", row.group},
                     {"holds", row.done ? Json(row.finding.holds) : Json(nullptr)},
                     {"seconds", row.seconds},
                     {"must", row.must},
                     {"seen", row.finding.seen}});
  return cases;
}

Json feature_json(const std::vector<FeatureCost>& costs) {
  Json features = Json::array();
  for (const FeatureCost& cost : costs)
    features.push_back({{"feature", cost.feature},
                        {"kinematics", cost.kinematics},
                        {"scene", cost.scene},
                        {"without_s", cost.time_without},
                        {"with_s", cost.time_with},
                        {"difference", cost.difference},
                        {"same_failures", cost.same_failures},
                        {"agrees", cost.agrees()}});
  return features;
}

}  // namespace app::bench

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* bench_footer =
    "error      error against run time: problems with a known answer, and the paper's tension test, solved "
    "in "
    "many ways;\n"
    "           error_vs_time.html, error.csv, a chart a problem and the cheapest way to 5, 1 and 0.1 %\n"
    "stability  the limits of the solver, each with what must come of it; stability.html and stability.csv; "
    "fails when\n"
    "           one does not hold\n"
    "features   the cost of every feature that a scene can leave out, with and without, and whether the "
    "results "
    "agree;\n"
    "           features.html and features.csv\n"
    "Example: two problems, in less than a minute\n"
    "  mesopix bench error --problem bar --problem inclusion -o runs/error";

const std::vector<std::string>& benches() {
  static const std::vector<std::string> names{"error", "stability", "features"};
  return names;
}

/// What a bench leaves.
struct Found {
  std::string csv, html, text;
  nlohmann::ordered_json json;
  bool complete = true;    ///< else it was interrupted
  const char* kept = "";   ///< "the cases that were done are", when it was
  const char* fault = "";  ///< what is wrong with the program; empty = nothing
};

class BenchCommand : public Command {
 public:
  explicit BenchCommand(CLI::App& program)
      : Command(program, "bench", "Measure error against run time, stability, and what features cost",
                bench_footer) {
    option("WHAT", what_, listed(benches()), one_of(benches()));
    option("--problem", problems_, "error: problem to solve, e.g. bar; may be given again [all]",
           text_form("NAME"));
    option("--case", cases_, "stability: case to run, e.g. contrast; may be given again [all]",
           text_form("NAME"));
    folder_and_overwrite("runs/bench-WHAT, runs/bench-WHAT-2, ...");
    json_and_quiet("what was found as JSON on standard output");
  }

  Exit run(Console& console) override {
    if (what_.empty())
      throw Rejected(Exit::usage, "WHAT", "missing", "must be " + listed(benches()), "mesopix bench error");
    if (std::find(benches().begin(), benches().end(), what_) == benches().end())
      throw Rejected(Exit::usage, "WHAT", what_, "must be " + listed(benches()),
                     did_you_mean(what_, benches()));
    if (what_ != "error" && !problems_.empty())
      throw Rejected(Exit::usage, "--problem", "given with " + what_, "belongs to mesopix bench error");
    if (what_ != "stability" && !cases_.empty())
      throw Rejected(Exit::usage, "--case", "given with " + what_, "belongs to mesopix bench stability");
    const auto problems = bench::select_problems(problems_);
    (void)bench::select_cases(cases_);  // before a folder is made
    const FreshFolder folder(make_run_folder(output_, "bench-" + what_, overwrite_));
    const InterruptGuard guard;
    const Found found = [&] {
      TerminalLine line(console);
      const auto told = [&](std::size_t done, std::size_t all) {
        line.show(fmt::format("{} of {} runs   {:.0f} s", done, all, line.elapsed()));
      };
      const Watch watch{told, [&] { return !guard.interrupted(); }};
      if (what_ == "error") return errors(problems, folder.path(), watch);
      return what_ == "stability" ? limits(watch) : features(watch);
    }();
    mpm::replace_file((folder.path() / (what_ + ".csv")).string(), found.csv);
    const std::string page = what_ == "error" ? "error_vs_time.html" : what_ + ".html";
    mpm::replace_file((folder.path() / page).string(), found.html);
    if (json_)
      console.out << json_text(found.json);
    else if (!console.quiet)
      console.out << found.text;
    console.say("wrote " + folder.path().string());
    if (!found.complete) {
      console.say(std::string("interrupted; ") + found.kept + " kept");
      return Exit::interrupted;
    }
    if (*found.fault != '\0')
      throw Rejected(Exit::internal, "bench " + what_, found.fault, "see " + folder.path().string());
    return Exit::ok;
  }

 private:
  static Found errors(const std::vector<bench::Problem>& problems, const fs::path& folder,
                      const Watch& watch) {
    const auto results = bench::study_errors(problems, watch);
    for (const bench::ProblemResult& result : results)
      mpm::replace_file((folder / (result.problem.name + ".png")).string(), bench::error_png(result));
    return {bench::error_csv(results),  bench::error_html(results),        bench::error_text(results),
            bench::error_json(results), results.size() == problems.size(), "the problems that were done are"};
  }

  [[nodiscard]] Found limits(const Watch& watch) const {
    const bench::StabilityOutcome outcome = bench::run_stability({cases_, core_count()}, watch);
    return {bench::stability_csv(outcome),
            bench::stability_html(outcome),
            bench::stability_text(outcome),
            bench::stability_json(outcome),
            watch.goes_on(),
            "the cases that were done are",
            outcome.holds() ? "" : "a case does not hold"};
  }

  static Found features(const Watch& watch) {
    const std::vector<bench::FeatureCase> cases = bench::all_features();
    const std::vector<bench::FeatureCost> costs = bench::measure_features(cases, 5, watch);
    const bool agree =
        std::all_of(costs.begin(), costs.end(), [](const auto& cost) { return cost.agrees(); });
    return {bench::feature_csv(costs),
            bench::feature_html(costs),
            bench::feature_text(costs),
            bench::feature_json(costs),
            costs.size() == cases.size(),
            "what was measured is",
            agree ? "" : "a feature that was left out changed the results"};
  }

  std::string what_;
  std::vector<std::string> problems_;
  std::vector<std::string> cases_;
};

}  // namespace

CommandPointer bench_command(CLI::App& parent) { return std::make_unique<BenchCommand>(parent); }

}  // namespace app
