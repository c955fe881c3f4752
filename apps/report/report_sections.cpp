#include "apps/report/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include "apps/drawing/damage_picture.hpp"
#include "apps/text/words.hpp"

#include "apps/drawing/drawing_files.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/report/fixture_drawing.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/version.hpp"
#include "specimen/describe/doubts.hpp"
#include "specimen/picture/picture.hpp"

namespace output {
namespace {

/// Without the unit.
std::string size_in_mm(const specimen::LabelledMask& mask) {
  return concise(1e3 * mask.width(), 4) + " × " + concise(1e3 * mask.height(), 4);
}

std::string size_in_pixels(const specimen::LabelledMask& mask) {
  return grouped(mask.labels.cols) + " × " + grouped(mask.labels.rows);
}

Fact count_fact(const std::string& name, std::int64_t count, const char* noun) {
  return {name, grouped(count), app::noun_for(count, noun)};
}

std::vector<Fact> failure_facts(const mpm::Result& result) {
  return {count_fact("Failures in tension", result.tension_failures, "point"),
          count_fact("Failures in shear", result.shear_failures, "point")};
}

/// What the last row of the history stands for.
std::string when(const RunRecord& record) { return record.goes_on ? " now" : " at the end"; }

std::vector<Fact> strength_facts(const RunRecord& record, const mpm::HistoryRow& end) {
  const mpm::Result& result = record.result;
  const StrainUnit unit = strain_unit(result);
  const bool peak = mpm::peak_reached(result);
  return {{peak ? "Peak stress" : "Largest stress, no peak", rounded(1e-6 * result.peak_stress), "MPa"},
          {peak ? "Strain at the peak" : "Strain at it", rounded(unit.per_strain * result.peak_strain),
           unit.name},
          {"Secant modulus at 40 %", rounded(1e-9 * secant_modulus(result)), "GPa"},
          {"Stress" + when(record), rounded(1e-6 * end.stress), "MPa"},
          {"Strain" + when(record), rounded(unit.per_strain * end.strain), unit.name},
          {"Work of the platens", rounded(end.platen_work), "J/m"}};
}

std::vector<Fact> flight_facts(const RunRecord& record, const mpm::HistoryRow& end) {
  const mpm::Result& result = record.result;
  const StrainUnit unit = strain_unit(result);
  const double at_start = result.history.empty() ? 0 : result.history.front().kinetic;
  const bool peak = mpm::peak_reached(result);
  return {{peak ? "Peak stress on the walls" : "Largest stress on the walls",
           rounded(1e-6 * result.peak_stress), "MPa"},
          {peak ? "Nominal strain at the peak" : "Nominal strain at it",
           rounded(unit.per_strain * result.peak_strain), unit.name},
          {"Time" + when(record), rounded(1e3 * end.time), "ms"},
          {"Initial kinetic energy", rounded(at_start), "J/m"},
          {"Kinetic energy" + when(record), rounded(end.kinetic), "J/m"}};
}

/// Row of the history from which on points move; nullptr = they never do.
const mpm::HistoryRow* first_row_in_motion(const mpm::Result& result) {
  const auto moves = [](const mpm::HistoryRow& row) { return row.moving_points > 0; };
  const auto row = std::find_if(result.history.begin(), result.history.end(), moves);
  return row == result.history.end() ? nullptr : &*row;
}

/// What moving points add to the figures of a run.
std::vector<Fact> motion_facts(const RunRecord& record, const mpm::HistoryRow& end) {
  std::vector<Fact> facts;
  const StrainUnit unit = strain_unit(record.result);
  const mpm::HistoryRow* row = first_row_in_motion(record.result);
  if (record.scene.kinematics == mpm::Kinematics::automatic)
    facts.push_back(row == nullptr ? Fact{"Hand-over to moving points", "none"}
                                   : Fact{"Hand-over to moving points",
                                          rounded(unit.per_strain * row->strain), unit.name});
  if (end.left_points > 0) facts.push_back(count_fact("Left the grid", end.left_points, "point"));
  return facts;
}

/// Of a test with loads: its force, and what its gauges read then and at the end.
std::vector<Fact> load_facts(const RunRecord& record, const mpm::HistoryRow& end) {
  const mpm::Result& result = record.result;
  const mpm::Scene& scene = record.scene;
  const bool peak = mpm::peak_reached(result);
  std::vector<Fact> facts{
      {peak ? "Peak force" : "Largest force", rounded(1e-3 * leading_force(scene, result.peak_stress)), "kN"},
      {peak ? "Displacement at the peak" : "Displacement at it",
       rounded(1e3 * leading_displacement(scene, result.peak_strain)), "mm"},
      {"Force" + when(record), rounded(1e-3 * leading_force(scene, end.stress)), "kN"},
      {"Displacement" + when(record), rounded(1e3 * leading_displacement(scene, end.strain)), "mm"}};
  for (const mpm::GaugeReadings& gauge : result.gauges)
    if (!gauge.values.empty())
      facts.push_back({gauge.name + when(record), rounded(1e3 * gauge.values.back()), "mm"});
  return facts;
}

std::vector<Fact> run_facts(const RunRecord& record) {
  const mpm::Result& result = record.result;
  const mpm::HistoryRow end = result.history.empty() ? mpm::HistoryRow{} : result.history.back();
  std::vector<Fact> facts = record.scene.fixture.has_loads() ? load_facts(record, end)
                            : has_platens(record.scene)      ? strength_facts(record, end)
                                                             : flight_facts(record, end);
  for (const std::vector<Fact>& more : {failure_facts(result), motion_facts(record, end)})
    facts.insert(facts.end(), more.begin(), more.end());
  return facts;
}

/// Diameters of the circles of the same area.
Fact diameter_fact(const std::vector<specimen::Inclusion>& inclusions) {
  const auto [least, largest] = std::minmax_element(
      inclusions.begin(), inclusions.end(),
      [](const auto& a, const auto& b) { return a.equivalent_diameter < b.equivalent_diameter; });
  const std::string from = rounded(1e3 * least->equivalent_diameter);
  const std::string to = rounded(1e3 * largest->equivalent_diameter);
  if (from == to) return {"Equivalent diameter", to, "mm"};
  return {"Equivalent diameters", from + " to " + to, "mm"};
}

std::vector<Fact> specimen_facts(const RunRecord& record) {
  const specimen::LabelledMask& mask = record.specimen.mask;
  std::vector<Fact> facts{{"Size", size_in_mm(mask), "mm"},
                          {"Picture", size_in_pixels(mask), "pixels"},
                          {"Pixel size", concise(1e3 * mask.pixel_size), "mm"}};
  for (const auto& [phase, share] : phase_shares(mask))
    facts.push_back({"Area share of " + phase_word(phase), with_decimals(100 * share, 2), "%"});
  const std::vector<specimen::Inclusion>& inclusions = record.specimen.inclusions;
  facts.push_back(count_fact("Aggregates", static_cast<std::int64_t>(inclusions.size()), "piece"));
  if (!inclusions.empty()) facts.push_back(diameter_fact(inclusions));
  if (!record.scene.extra_points.empty())
    facts.push_back(
        count_fact("Extra ITZ points", static_cast<std::int64_t>(record.scene.extra_points.size()), "point"));
  return facts;
}

std::string specimen_picture(const specimen::LabelledMask& mask) {
  return image(specimen::preview(mask), "The phases of the specimen", "") +
         legend("below", phases_in(mask, specimen::phase_colour));
}

std::vector<std::string> failure_row(const FailureCount& count, bool with_crushed) {
  std::vector<std::string> row{capitalised(phase_word(count.phase)), grouped(count.points),
                               grouped(count.tension), grouped(count.shear)};
  if (with_crushed) row.push_back(grouped(count.crushed));
  row.push_back(grouped(count.intact()));
  const auto failed = static_cast<double>(count.tension + count.shear);
  row.push_back(count.points == 0 ? "" : percent(failed / static_cast<double>(count.points), 2));
  return row;
}

std::vector<Fact> solution_facts(const RunRecord& record) {
  const mpm::Result& result = record.result;
  if (record.scene.method == mpm::SolverMethod::quasi_static)
    return {count_fact("Material points", result.points, "point"),
            count_fact("States in equilibrium", result.steps, "state"),
            {"Wall time", rounded(result.wall_time), "s"},
            {"Largest energy imbalance", rounded(100 * result.energy_error, 2), "% of the work"}};
  return {count_fact("Material points", result.points, "point"),
          count_fact("Steps", result.steps, "step"),
          {"Time step", rounded(1e9 * result.dt), "ns"},
          {"Wall time", rounded(result.wall_time), "s"},
          {"Speed", rounded(1e-6 * result.point_updates_per_second()), "million point updates/s"},
          {"Largest energy imbalance", rounded(100 * result.energy_error, 2),
           has_platens(record.scene) ? "% of the work" : "% of the initial energy"},
          count_fact("Threads", result.threads, "thread")};
}

std::vector<Fact> provenance_facts(const RunRecord& record) {
  const specimen::Provenance& provenance = record.specimen.provenance;
  std::vector<Fact> facts;
  if (!record.goes_on) facts.push_back({"Ended because", phrase_of(record.result.stop)});
  facts.insert(facts.end(), {{"Program", std::string("mesopix ") + app::version()},
                             {"Kinematics", name_of_kinematics(record.scene)},
                             {"Arithmetic", word_of(record.scene.precision) + " precision, " +
                                                record.result.instruction_set},
                             {"Specimen", provenance.source}});
  if (!provenance.version.empty()) facts.push_back({"Specimen made by", "mesopix " + provenance.version});
  if (!provenance.sha256.empty()) facts.push_back({"Source SHA-256", provenance.sha256});
  if (provenance.seed != 0) facts.push_back({"Aggregate seed", std::to_string(provenance.seed)});
  facts.push_back({"Strength seed", std::to_string(record.scene.damage.seed)});
  facts.push_back({"Scene SHA-256", record.scene_hash});
  facts.push_back({"Run SHA-256", run_digest(record.scene_toml, record.scene)});
  return facts;
}

}  // namespace

std::string title_of(const RunRecord& record) {
  if (!record.title.empty()) return record.title;
  return capitalised(name_of_loading(record.scene)) + " of a specimen of " +
         size_in_mm(record.specimen.mask) + " mm";
}

std::string header_html(const RunRecord& record) {
  const mpm::Scene& scene = record.scene;
  const std::string setting =
      fmt::format("{}, {}; {} mm, {} pixels", capitalised(setting_of_loading(scene)), word_of(scene.plane),
                  size_in_mm(record.specimen.mask), size_in_pixels(record.specimen.mask));
  return heading(title_of(record), setting);
}

std::string notes_section(const RunRecord& record) {
  return warnings_section(specimen::doubts_of(record.specimen)) +
         (record.notes.empty() ? "" : section("Notes", notes_list(record.notes)));
}

std::string facts_part(const RunRecord& record) { return facts_table(run_facts(record)); }

std::string curve_section(const RunRecord& record) {
  const char* heading = record.scene.fixture.has_loads() ? "Force and displacement" : "Stress and strain";
  return section(heading, side_by_side("lead",
                                       chart_figure("stress", stress_chart(record), 590, 400,
                                                    meaning_of_curve(record.scene)),
                                       part("facts", facts_part(record))));
}

std::string specimen_section(const RunRecord& record) {
  std::string html =
      side_by_side("fit", specimen_picture(record.specimen.mask), facts_table(specimen_facts(record)));
  const mpm::Fixture& fixture = record.scene.fixture;
  if (fixture.has_loads() || !fixture.gauges.empty())
    html +=
        "<figure class=\"chart\">\n" + svg_of(fixture_drawing(record.specimen.mask, record.scene)) +
        "<figcaption>The set-up: triangles hold, arrows move, dots are the ends of gauges; a line below a "
        "triangle says that it slides.</figcaption>\n</figure>\n";
  const Chart sieve = sieve_chart(record.specimen);
  if (!sieve.series.empty())
    html += chart_figure("sieve", sieve, 590, 330,
                         "Share of the aggregate area in aggregates below a diameter; the diameter is that "
                         "of the circle with the "
                         "same area.");
  return section("Specimen", html);
}

std::string ledger_section(const RunRecord& record) {
  std::string html = side_by_side(
      "even", chart_figure("energy", energy_chart(record), 480, 330, meaning_of_energy(record.scene)),
      chart_figure("failure", failure_chart(record), 480, 330, "Number of points that have failed."));
  const Chart strains = failure_strain_chart(record);
  if (!strains.series.empty())
    html += chart_figure("failure-strain", strains, 590, 300, "Number of pixels that failed, by strain.");
  else if (record.goes_on)
    html += chart_place("failure-strain", "Number of pixels that failed, by strain.");
  return section("Energies and failures", html + part("failures", failures_part(record)));
}

std::string failures_part(const RunRecord& record) {
  const bool with_crushed = record.result.crush_strain.size() > 0;
  std::vector<std::string> head{"Phase", "Points", "Tension", "Shear"};
  if (with_crushed) head.emplace_back("Crushed later");
  head.insert(head.end(), {"Intact", "Failed"});
  std::vector<std::vector<std::string>> rows;
  const std::vector<FailureCount> by_phase = failures_by_phase(record);
  for (const FailureCount& count : by_phase)
    if (count.phase != "void") rows.push_back(failure_row(count, with_crushed));
  if (!record.scene.extra_points.empty())
    rows.push_back(failure_row(failures_of_extra_points(record, by_phase), with_crushed));
  return number_table(head, rows);
}

std::string solution_section(const RunRecord& record) {
  return section("Solution and provenance", part("solution", solution_part(record)));
}

std::string solution_part(const RunRecord& record) {
  return side_by_side("even", facts_table(solution_facts(record)), facts_table(provenance_facts(record)));
}

std::string scene_section(const RunRecord& record) {
  const std::string& options = record.specimen.provenance.options;
  return section("Scene", folded("The scene, with every default written out", record.scene_toml) +
                              (options.empty() ? "" : folded("How the specimen was made", options)));
}

std::string citation_section(const RunRecord& record) {
  return section(
      "How to cite",
      fmt::format(
          "<blockquote>mesopix {}: from a picture of concrete to a broken specimen (computer program). "
          "Scene {}.</blockquote>\n"
          "<p>The model is that of</p>\n"
          "<blockquote>Liu, Zou, Hu, Liu, Cong and Zhang: Numerical Simulation of Mesodamage Behavior of "
          "Concrete Based on Material Point Method. Advances in Civil Engineering (2020).</blockquote>\n",
          escape(app::version()), escape(record.scene_hash.substr(0, 12))));
}

}  // namespace output
