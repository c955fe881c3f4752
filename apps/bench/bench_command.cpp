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

/// One line on the terminal that tells how far the runs are.
class CountLine {
 public:
  explicit CountLine(Console& console) : line_(console.err, console.err_is_terminal && !console.quiet) {}

  void show(std::size_t done, std::size_t all) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    line_.show(fmt::format("{} of {} runs   {:.0f} s", done, all, elapsed.count()));
  }

 private:
  TerminalLine line_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

BenchCommand::BenchCommand(CLI::App& program)
    : Command(program, "bench", "Measure error against run time, stability, and what features cost",
              bench_footer) {
  options().value("WHAT", what_, listed(benches()), one_of(benches()));
  options().value("--problem", problems_, "error: problem to solve, e.g. bar; may be given again [all]",
                  text_form("NAME"));
  options().value("--case", cases_, "stability: case to run, e.g. contrast; may be given again [all]",
                  text_form("NAME"));
  options().value("-o,--output", output_, "folder [runs/bench-WHAT, runs/bench-WHAT-2, ...]", folder_form());
  options().add_flag("--overwrite", overwrite_, "write into a folder that is not empty");
  options().add_flag("--json", json_, "what was found as JSON on standard output");
  options().add_flag("-q,--quiet", quiet_, "say nothing but errors");
}

Exit BenchCommand::run(Console& console) {
  console.quiet = quiet_;
  if (what_.empty())
    throw Rejected(Exit::usage,
                   complaint("WHAT", "missing", "must be " + listed(benches()), "mesopix bench error"));
  if (std::find(benches().begin(), benches().end(), what_) == benches().end())
    throw Rejected(Exit::usage,
                   complaint("WHAT", what_, "must be " + listed(benches()), did_you_mean(what_, benches())));
  if (what_ != "error" && !problems_.empty())
    throw Rejected(Exit::usage,
                   complaint("--problem", "given with " + what_, "belongs to mesopix bench error"));
  if (what_ != "stability" && !cases_.empty())
    throw Rejected(Exit::usage,
                   complaint("--case", "given with " + what_, "belongs to mesopix bench stability"));
  if (what_ == "error") return run_error(console);
  return what_ == "stability" ? run_stability(console) : run_features(console);
}

Exit BenchCommand::run_error(Console& console) const {
  const std::vector<bench::Problem> problems = bench::select_problems(problems_);
  const FreshFolder folder(make_run_folder(output_, "bench-error", overwrite_));
  const InterruptGuard guard;
  const auto results = [&] {
    CountLine line(console);
    return bench::study_errors(problems, {[&](std::size_t done, std::size_t all) { line.show(done, all); },
                                          [&] { return !guard.interrupted(); }});
  }();
  mpm::replace_file((folder.path() / "error.csv").string(), bench::error_csv(results));
  mpm::replace_file((folder.path() / "error_vs_time.html").string(), bench::error_html(results));
  for (const bench::ProblemResult& result : results)
    mpm::replace_file((folder.path() / (result.problem.name + ".png")).string(), bench::error_png(result));
  if (json_)
    console.out << json_text(bench::error_json(results));
  else if (!console.quiet)
    console.out << bench::error_text(results);
  console.say("wrote " + folder.path().string());
  if (results.size() == problems.size()) return Exit::ok;
  console.say("interrupted; the problems that were done are kept");
  return Exit::interrupted;
}

Exit BenchCommand::run_stability(Console& console) const {
  static_cast<void>(bench::select_cases(cases_));  // before a folder is made
  const FreshFolder folder(make_run_folder(output_, "bench-stability", overwrite_));
  const InterruptGuard guard;
  const bench::StabilityOutcome outcome = [&] {
    CountLine line(console);
    return bench::run_stability(
        {cases_, core_count()}, [&](std::size_t done, std::size_t all) { line.show(done, all); },
        [&] { return !guard.interrupted(); });
  }();
  mpm::replace_file((folder.path() / "stability.csv").string(), bench::stability_csv(outcome));
  mpm::replace_file((folder.path() / "stability.html").string(), bench::stability_html(outcome));
  if (json_)
    console.out << json_text(bench::stability_json(outcome));
  else if (!console.quiet)
    console.out << bench::stability_text(outcome);
  console.say("wrote " + folder.path().string());
  if (guard.interrupted()) {
    console.say("interrupted; the cases that were done are kept");
    return Exit::interrupted;
  }
  if (!outcome.holds())
    throw Rejected(Exit::internal,
                   complaint("bench stability", "a case does not hold", "see " + folder.path().string()));
  return Exit::ok;
}

Exit BenchCommand::run_features(Console& console) const {
  const FreshFolder folder(make_run_folder(output_, "bench-features", overwrite_));
  const InterruptGuard guard;
  const std::vector<bench::FeatureCase> cases = bench::all_features();
  const std::vector<bench::FeatureCost> costs = [&] {
    CountLine line(console);
    return bench::measure_features(
        cases, 5, [&](std::size_t done, std::size_t all) { line.show(done, all); },
        [&] { return !guard.interrupted(); });
  }();
  mpm::replace_file((folder.path() / "features.csv").string(), bench::feature_csv(costs));
  mpm::replace_file((folder.path() / "features.html").string(), bench::feature_html(costs));
  if (json_)
    console.out << json_text(bench::feature_json(costs));
  else if (!console.quiet)
    console.out << bench::feature_text(costs);
  console.say("wrote " + folder.path().string());
  if (costs.size() < cases.size()) {
    console.say("interrupted; what was measured is kept");
    return Exit::interrupted;
  }
  const bool agree = std::all_of(costs.begin(), costs.end(), [](const auto& cost) { return cost.agrees(); });
  if (!agree)
    throw Rejected(Exit::internal,
                   complaint("bench features", "a feature that was left out changed the results", ""));
  return Exit::ok;
}

}  // namespace app
