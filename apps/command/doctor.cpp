#include "apps/command/doctor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/system/processes.hpp"
#include "apps/text/words.hpp"
#include "libmpm/files/hdf5_version.hpp"
#include "specimen/picture/image_libraries.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double gigabyte = 1e9;
constexpr double least_disk = 1e9, least_memory = 5e8;  // [bytes]
constexpr double least_share = 0.02;                    // of the peak; less is no machine, but a fault

std::string gigabytes(double bytes) { return fmt::format("{:.1f} GB", bytes / gigabyte); }

Finding ok(const char* topic, std::string text) { return {Health::ok, topic, std::move(text), {}}; }

Finding warning(const char* topic, std::string text, std::string cure) {
  return {Health::warning, topic, std::move(text), std::move(cure)};
}

Finding about_build(const Build& build) {
  const std::string text = fmt::format("mesopix {}, {}, {}{}", version(), build.compiler,
                                       *build.type == '\0' ? "no build type" : build.type,
                                       build.sanitized ? " with a sanitizer" : "");
  const bool fast = std::strcmp(build.type, "Debug") != 0 && *build.type != '\0' && !build.sanitized;
  if (fast) return ok("program", text);
  return warning("program", text, "runs are many times slower than they could be; cmake --preset release");
}

Finding about_processor(const Machine& machine) {
  const std::string& name = machine.processor;
  const std::string text =
      fmt::format("{}, runs {}; {} is used", name.empty() ? "unknown" : name,
                  listed(machine.instruction_sets, "and"), machine.instruction_sets.front());
  return ok("processor", text);
}

Finding about_threads(const Machine& machine) {
  const std::string text = fmt::format("{}, {} idle; a run takes up to {}", counted(machine.cores, "core"),
                                       machine.idle_cores, counted(machine.idle_cores, "thread"));
  if (machine.quota > 0 && machine.quota < machine.cores)
    return warning("threads",
                   fmt::format("{}, and the container may use the time of {:.3g}",
                               counted(machine.cores, "core"), machine.quota),
                   fmt::format("give --threads {0} to simulate, --jobs {0} to study",
                               std::max(1, static_cast<int>(machine.quota))));
  if (machine.cores == 1)
    return warning("threads", text, "nothing runs side by side; results do not depend on it");
  if (machine.idle_cores == 1)
    return warning("threads", text,
                   "end other programs, which keep the others busy; results do not depend on it");
  return ok("threads", text);
}

Finding about_memory(const Machine& machine) {
  const auto limit = static_cast<double>(machine.memory_limit);
  const std::string text = fmt::format("{}, {} free; {}", gigabytes(static_cast<double>(machine.memory)),
                                       gigabytes(static_cast<double>(machine.free_memory)),
                                       limit > 0 ? "a run may take " + gigabytes(limit) : "no limit is kept");
  const double could_be_had = limit > 0 ? std::min(limit, static_cast<double>(machine.free_memory))
                                        : static_cast<double>(machine.free_memory);
  if (could_be_had >= least_memory) return ok("memory", text);
  return warning("memory", text, "a million points take 100 MB; end other programs, or use larger pixels");
}

Finding about_disk(const Examination& it) {
  const std::string text =
      fmt::format("{} free in {}", gigabytes(static_cast<double>(it.free_disk)), it.folder);
  if (!it.why_not_writable.empty())
    return {Health::failed, "disk",
            fmt::format("{} cannot be written to: {}", it.folder, it.why_not_writable),
            "go to another folder, or give -o FOLDER", Exit::io};
  if (static_cast<double>(it.free_disk) >= least_disk) return ok("disk", text);
  return warning("disk", text, "runs with frames take more; make room, or give -o FOLDER on another disk");
}

Finding about_libraries(const Examination& it) {
  std::string text;
  for (const auto& [name, number] : it.libraries)
    text.append(text.empty() ? "" : ", ").append(name).append(" ").append(number);
  return ok("libraries", text);
}

Finding about_terminal(const Examination& it) {
  const TerminalEnvironment& terminal = it.terminal;
  if (!it.has_terminal)
    return ok("terminal", "messages go to a file or another program, without progress lines");
  const std::string text = fmt::format("{}{}, {}", terminal.is_utf8() ? "UTF-8" : "not UTF-8",
                                       terminal.locale.empty() ? "" : " (" + terminal.locale + ")",
                                       terminal.no_color        ? "NO_COLOR is set"
                                       : terminal.has_colours() ? "with colours"
                                                                : "without colours");
  if (terminal.is_utf8()) return ok("terminal", text);
  return warning("terminal", text,
                 "names with other letters than ASCII may look wrong; export LC_ALL=C.UTF-8");
}

Finding about_slurm(const std::string& version) {
  return ok("cluster", version.empty() ? "no sbatch in the PATH; studies run on this machine" : version);
}

/// What the self test found wrong; empty when nothing is.
std::string wrong(const SelfTest& test) {
  if (!(test.modulus_error < SelfTest::allowed_modulus_error))
    return fmt::format("the modulus of an elastic block is {:.3g} % off", 100 * test.modulus_error);
  if (!(test.peak_error < SelfTest::allowed_peak_error))
    return fmt::format("the peak stress of a block that cracks is {:.3g} % off", 100 * test.peak_error);
  return test.same_on_threads ? "" : fmt::format("{} threads give other bits than one", test.threads);
}

Finding about_numbers(const SelfTest& test) {
  if (!test.is_right())
    return {Health::failed, "numbers", wrong(test), "build the program again; if it stays, please report it",
            Exit::internal};
  return ok("numbers",
            fmt::format("modulus of an elastic block {:.2g} % off; a cracking one as known, and the "
                        "same bits on 1 and {} threads",
                        100 * test.modulus_error, test.threads));
}

Finding about_speed(const SelfTest& test) {
  const std::string text =
      fmt::format("{:.0f} million point-updates a second on one core, {:.0f} % of what it can do at most",
                  1e-6 * test.updates_per_second, 100 * test.share_of_peak);
  if (test.share_of_peak >= least_share) return ok("speed", text);
  return warning("speed", text,
                 "another program may keep the core busy; else build with cmake --preset release");
}

/// "slurm 22.05.8"; empty where there is no sbatch.
std::string slurm_version() {
  try {
    const ProgramOutcome outcome = run_other_program({"sbatch", "--version"});
    return outcome.code == 0 ? outcome.out.substr(0, outcome.out.find('\n')) : std::string();
  } catch (const Rejected&) {
    return {};
  }
}

std::string word_of(Health health) {
  return word_in({{Health::ok, "ok"}, {Health::warning, "warning"}, {Health::failed, "failed"}}, health);
}

Json finding_json(const Finding& finding) {
  return {{"health", word_of(finding.health)},
          {"topic", finding.topic},
          {"text", finding.text},
          {"cure", finding.cure.empty() ? Json(nullptr) : Json(finding.cure)}};
}

Json figures_json(const Examination& it) {
  Json libraries = Json::object();
  for (const auto& [name, number] : it.libraries) libraries[name] = number;
  return {{"version", version()},
          {"compiler", it.build.compiler},
          {"build_type", it.build.type},
          {"processor", it.machine.processor},
          {"instruction_sets", it.machine.instruction_sets},
          {"cores", it.machine.cores},
          {"idle_cores", it.machine.idle_cores},
          {"quota_cores", it.machine.quota > 0 ? Json(it.machine.quota) : Json(nullptr)},
          {"memory_B", it.machine.memory},
          {"free_memory_B", it.machine.free_memory},
          {"memory_limit_B", it.machine.memory_limit > 0 ? Json(it.machine.memory_limit) : Json(nullptr)},
          {"free_disk_B", it.free_disk},
          {"libraries", libraries},
          {"slurm", it.slurm.empty() ? Json(nullptr) : Json(it.slurm)},
          {"modulus_error", it.self_test.modulus_error},
          {"peak_error", it.self_test.peak_error},
          {"same_on_threads", it.self_test.same_on_threads},
          {"threads", it.self_test.threads},
          {"point_updates_per_second", it.self_test.updates_per_second},
          {"share_of_peak", it.self_test.share_of_peak}};
}

}  // namespace

Examination examine(bool has_terminal) {
  Examination it;
  it.build = build();
  it.machine = this_machine();
  it.libraries = specimen::image_libraries();
  it.libraries.insert(it.libraries.begin(), {"HDF5", mpm::hdf5_version()});
  it.folder = std::filesystem::current_path().string();
  it.free_disk = free_disk(it.folder);
  it.why_not_writable = why_not_writable(it.folder);
  it.has_terminal = has_terminal;
  it.terminal = terminal_environment();
  it.slurm = slurm_version();
  it.self_test = run_self_test(std::max(2, it.machine.idle_cores));
  return it;
}

std::vector<Finding> findings_of(const Examination& it) {
  return {about_build(it.build),
          about_processor(it.machine),
          about_threads(it.machine),
          about_memory(it.machine),
          about_disk(it),
          about_libraries(it),
          about_terminal(it),
          about_slurm(it.slurm),
          about_numbers(it.self_test),
          about_speed(it.self_test)};
}

Exit code_of(const std::vector<Finding>& findings) {
  Exit code = Exit::ok;
  for (const Finding& finding : findings)
    if (finding.health == Health::failed && code != Exit::internal) code = finding.code;
  return code;
}

std::vector<Finding> unwell(const std::vector<Finding>& findings) {
  std::vector<Finding> found;
  for (const Finding& finding : findings)
    if (finding.health != Health::ok) found.push_back(finding);
  return found;
}

std::string findings_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings)
    text += fmt::format("{:<8} {:<10} {}{}\n", word_of(finding.health), finding.topic,
                        printable(finding.text), finding.cure.empty() ? "" : "; " + finding.cure);
  return text;
}

nlohmann::ordered_json examination_json(const Examination& examination,
                                        const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) list.push_back(finding_json(finding));
  return {{"ready", code_of(findings) == Exit::ok},
          {"findings", std::move(list)},
          {"figures", figures_json(examination)}};
}

}  // namespace app
