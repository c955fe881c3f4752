#include "apps/study/study_table.hpp"

#include <cmath>

#include "apps/report/curve_csv.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/text.hpp"
#include "apps/study/study_values.hpp"

namespace app {
namespace {

using mpm::TableColumn;

constexpr const char* state_words[] = {"open", "done", "failed"};

/// A figure of the result of a member.
struct Figure {
  const char *name, *unit, *meaning;
  double (*of)(const MemberOutcome&);
};

constexpr Figure figures[] = {
    {"peak_stress", "Pa", "largest stress", [](const auto& o) { return o.figures.peak_stress; }},
    {"peak_strain", "1", "strain at the largest stress", [](const auto& o) { return o.figures.peak_strain; }},
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
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted_text = "\"";
  for (const char c : text) quoted_text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted_text + '"';
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
