#include "apps/study/study_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "apps/report/key_figures.hpp"
#include "apps/report/run_words.hpp"
#include "apps/run/run_remarks.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/study/study_values.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/text_parts.hpp"
#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"

namespace app {
namespace {

constexpr std::size_t points_kept = 200;

/// Every so many rows of the history, and the one at the peak.
Curve thinned(const mpm::Result& result) {
  const Curve whole = stress_curve(result);
  const std::size_t count = whole.strain.size();
  if (count <= points_kept) return whole;
  std::vector<std::size_t> rows{peak_row(result)};
  for (std::size_t i = 0; i < points_kept; ++i) rows.push_back(i * (count - 1) / (points_kept - 1));
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  Curve curve;
  for (const std::size_t row : rows) {
    curve.strain.push_back(whole.strain[row]);
    curve.stress.push_back(whole.stress[row]);
  }
  return curve;
}

/// Whether a scene that a result keeps is that of the member; its help and units may be worded otherwise.
bool is_scene_of(const Member& member, const std::string& scene) {
  try {
    return identity_of(resolve(parse_scene(scene, ""), {}).settings) == member.id;
  } catch (const Rejected&) {
    return false;
  }
}

mpm::Result read_member(const StudyFolder& folder, const Member& member) {
  const std::string path = folder.result_file(member).string();
  const Hdf5Turn turn = hdf5_turn();
  if (!is_scene_of(member, mpm::read_scene_text(path)))
    throw mpm::FileError(path, "is the result of another scene", "", "remove it, and run the study again");
  return mpm::read_result(path);
}

void add_cracks(CrackCount& cracks, const mpm::Result& result) {
  const auto& mode = result.failure_mode;
  const bool first = cracks.members == 0;
  ++cracks.members;
  if (first) cracks.failures = mpm::PixelField<int>::Zero(mode.rows(), mode.cols());
  const bool fits = cracks.failures.rows() == mode.rows() && cracks.failures.cols() == mode.cols();
  if (fits)
    cracks.failures += (mode != 0).cast<int>();
  else
    cracks.failures.resize(0, 0);
}

MemberOutcome outcome_of(mpm::Result result, const mpm::Scene& scene) {
  MemberOutcome outcome{MemberState::done,          {}, {}, result.history.back(), mpm::peak_reached(result),
                        inertia_note(result, scene)};
  result.history.clear();
  drop_maps(result);
  outcome.figures = std::move(result);
  return outcome;
}

}  // namespace

std::size_t StudyResults::count(MemberState state) const {
  return static_cast<std::size_t>(std::count_if(
      outcomes.begin(), outcomes.end(), [&](const MemberOutcome& one) { return one.state == state; }));
}

std::vector<double> StudyResults::figure(const std::function<double(const MemberOutcome&)>& of) const {
  std::vector<double> values;
  for (const MemberOutcome& outcome : outcomes)
    values.push_back(outcome.state == MemberState::done ? of(outcome)
                                                        : std::numeric_limits<double>::quiet_NaN());
  return values;
}

namespace {

/// A figure of the peak; NaN where there is none.
double of_peak(const MemberOutcome& outcome, double mpm::Result::*figure) {
  return outcome.peak_reached ? outcome.figures.*figure : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<double> StudyResults::peak_stress() const {
  return figure([](const MemberOutcome& outcome) { return of_peak(outcome, &mpm::Result::peak_stress); });
}

std::vector<double> StudyResults::peak_strain() const {
  return figure([](const MemberOutcome& outcome) { return of_peak(outcome, &mpm::Result::peak_strain); });
}

std::size_t StudyResults::without_peak() const {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(), [](const MemberOutcome& outcome) {
        return outcome.state == MemberState::done && !outcome.peak_reached;
      }));
}

std::string without_peak_text(const StudyResults& results) {
  const std::size_t without = results.without_peak();
  if (without == 0) return {};
  return fmt::format(
      "{} of {} members reached no peak, as their stress had not fallen again when they ended; they count in "
      "no statistics; choose a larger loading.stop_strain",
      without, results.count(MemberState::done));
}

std::string inertia_text(const StudyResults& results) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = results.outcomes.size(); i-- > 0;)
    if (!results.outcomes[i].inertia.empty()) ++count, first = i;
  if (count == 0) return {};
  return fmt::format("{} of {} members are no slow tests, such as member {}: {}", count,
                     results.count(MemberState::done), first, results.outcomes[first].inertia);
}

StudyResults read_results(const StudyFolder& folder, const std::vector<Member>& members) {
  StudyResults results;
  for (const Member& member : members) {
    results.curves.emplace_back();
    if (folder.has_result(member)) {
      mpm::Result result = read_member(folder, member);
      results.curves.back() = thinned(result);
      add_cracks(results.cracks, result);
      results.outcomes.push_back(outcome_of(std::move(result), member.settings->scene));
    } else {
      const std::string reason = folder.failure(member);
      results.outcomes.push_back(
          {reason.empty() ? MemberState::open : MemberState::failed, reason, {}, {}, false});
    }
  }
  return results;
}

namespace {

using mpm::TableColumn;

constexpr const char* state_words[] = {"open", "done", "failed"};

/// A figure of the result of a member.
struct Figure {
  const char *name, *unit, *meaning;
  double (*of)(const MemberOutcome&);
};

constexpr Figure figures[] = {
    {"peak_stress", "Pa", "largest stress, where it is a peak",
     [](const auto& o) { return of_peak(o, &mpm::Result::peak_stress); }},
    {"peak_strain", "1", "strain at the peak",
     [](const auto& o) { return of_peak(o, &mpm::Result::peak_strain); }},
    {"peak_reached", "1", "1 = the largest stress is a peak, 0 = the stress had not fallen again at the end",
     [](const auto& o) { return o.peak_reached ? 1.0 : 0.0; }},
    {"end_strain", "1", "strain at the end", [](const auto& o) { return o.end.strain; }},
    {"end_stress", "Pa", "stress at the end", [](const auto& o) { return o.end.stress; }},
    {"tension_failures", "1", "points that failed in tension",
     [](const auto& o) { return static_cast<double>(o.figures.tension_failures); }},
    {"shear_failures", "1", "points that failed in shear",
     [](const auto& o) { return static_cast<double>(o.figures.shear_failures); }},
    {"platen_work", "J/m", "put in by the platens", [](const auto& o) { return o.end.platen_work; }},
    {"kinetic", "J/m", "kinetic energy at the end", [](const auto& o) { return o.end.kinetic; }},
    {"elastic", "J/m", "elastic energy at the end", [](const auto& o) { return o.end.elastic; }},
    {"released", "J/m", "elastic energy of the points that failed, when they failed",
     [](const auto& o) { return o.end.released; }},
    {"damped", "J/m", "taken by local damping", [](const auto& o) { return o.end.damped; }},
    {"left", "J/m", "energy of the points that left the grid", [](const auto& o) { return o.end.left; }},
    {"energy_error", "1", "largest imbalance of the energies over the platen work",
     [](const auto& o) { return o.figures.energy_error; }},
    {"points", "1", "material points", [](const auto& o) { return static_cast<double>(o.figures.points); }},
    {"steps", "1", "time steps", [](const auto& o) { return static_cast<double>(o.figures.steps); }},
    {"dt", "s", "time step", [](const auto& o) { return o.figures.dt; }},
};

/// A column of one value a member.
template <class T, class Of>
TableColumn column(std::string name, std::string unit, std::string meaning,
                   const std::vector<Member>& members, Of of) {
  std::vector<T> values;
  for (const Member& member : members) values.push_back(of(member));
  return {std::move(name), std::move(unit), std::move(meaning), std::move(values)};
}

TableColumn parameter_column(const StudyPlan& plan, std::size_t i, const std::vector<Member>& members) {
  const StudyParameter& parameter = plan.parameters[i];
  const std::string meaning = parameter.fields.front().help;
  if (is_number(parameter))
    return column<double>(parameter.name, unit_of(parameter), meaning, members,
                          [&](const Member& member) { return number_of(parameter, member.values[i]); });
  return column<std::string>(parameter.name, "1", meaning, members,
                             [&](const Member& member) { return text_of(parameter, member.values[i]); });
}

std::vector<TableColumn> first_columns(const std::vector<Member>& members) {
  return {column<std::int64_t>("member", "1", "number of the member", members,
                               [](const Member& m) { return static_cast<std::int64_t>(m.number); }),
          column<std::string>("id", "1", "of its files in members and failures", members,
                              [](const Member& m) { return m.id; })};
}

std::string stop_word(const MemberOutcome& outcome) {
  return outcome.state == MemberState::done ? output::word_of(outcome.figures.stop) : "";
}

std::string cell(double value) { return std::isfinite(value) ? output::exact(value) : ""; }
std::string cell(std::int64_t value) { return std::to_string(value); }
std::string cell(const std::string& text) {
  return text.find_first_of(",\"\r\n") == std::string::npos ? text : quoted_cell(text);
}

}  // namespace

std::vector<TableColumn> study_table(const Study& study, const std::vector<Member>& members,
                                     const StudyResults& results) {
  const auto& outcomes = results.outcomes;
  std::vector<TableColumn> table = first_columns(members);
  table.push_back(column<std::string>("state", "1", "done, failed or open", members, [&](const Member& m) {
    return std::string(state_words[static_cast<int>(outcomes[m.number].state)]);
  }));
  for (std::size_t i = 0; i < study.plan.parameters.size(); ++i)
    table.push_back(parameter_column(study.plan, i, members));
  if (!study.plan.seeds.empty())
    table.push_back(column<std::int64_t>("seed", "1", "of the random numbers", members,
                                         [](const Member& m) { return static_cast<std::int64_t>(*m.seed); }));
  for (const Figure& figure : figures)
    table.push_back({figure.name, figure.unit, figure.meaning, results.figure(figure.of)});
  table.push_back(column<std::string>("stop_reason", "1", "strain, time or drop", members,
                                      [&](const Member& m) { return stop_word(outcomes[m.number]); }));
  return table;
}

std::vector<TableColumn> timing_table(const std::vector<Member>& members, const StudyResults& results) {
  std::vector<TableColumn> table = first_columns(members);
  table.push_back({"wall_time", "s", "of the time steps",
                   results.figure([](const MemberOutcome& outcome) { return outcome.figures.wall_time; })});
  table.push_back(column<std::string>(
      "instruction_set", "1", "that the steps were computed with", members,
      [&](const Member& m) { return results.outcomes[m.number].figures.instruction_set; }));
  return table;
}

std::string table_csv(const std::vector<TableColumn>& columns) {
  std::string csv;
  for (const TableColumn& one : columns)
    csv += (csv.empty() ? "" : ",") + cell(output::column_title(one.name, one.unit));
  csv += '\n';
  const std::size_t rows = columns.empty() ? 0 : columns.front().rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      csv += (i == 0 ? "" : ",") +
             std::visit([&](const auto& values) { return cell(values[row]); }, columns[i].values);
    csv += '\n';
  }
  return csv;
}

}  // namespace app
