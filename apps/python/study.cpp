#include "apps/python/study.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <sstream>

#include "apps/python/options.hpp"
#include "apps/python/spectator.hpp"
#include "apps/python/views.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/study/study_growth.hpp"
#include "apps/study/study_outcome.hpp"
#include "apps/study/study_results.hpp"
#include "apps/system/job_pool.hpp"

namespace binding {
namespace {

/// mesopix.Study: owner of all that its arrays show.
struct Breakings {
  app::StudyFolder folder;
  app::WholeStudy whole;  ///< with results
  std::vector<mpm::TableColumn> table;
};

using BreakingsPointer = std::shared_ptr<Breakings>;

/// Arguments beside what the study is.
struct Wanted {
  int jobs = 1;
  double share = 0;  ///< of --until-ci, 0 = none
  bool retry = false;
};

Wanted wanted_of(const py::object& jobs, const py::object& until_ci, bool retry) {
  Wanted wanted{app::core_count(), 0, retry};
  if (!jobs.is_none()) {
    const int asked = app::read_option("jobs", option_text(jobs), app::IntegerCodec<>{app::between(1, 1024)});
    wanted.jobs = app::workers_within_cores(asked, "jobs").count;
  }
  if (!until_ci.is_none())
    wanted.share = app::read_option("until-ci", option_text(until_ci),
                                    app::QuantityCodec{app::Dimension::ratio, app::inside(0, 1)});
  return wanted;
}

/// Runs what is open; interrupted where the spectator ends it.
app::WholeStudy run(const app::StudyFolder& folder, app::Study study, std::vector<app::Member> members,
                    const Wanted& wanted, Spectator& spectator) {
  return work_apart(spectator, [&](Overseer& overseer) {
    const app::StudyWatch watch{
        [&](const app::StudyTally& tally) { overseer.look([&] { return glance_at(tally); }); },
        [&] { return overseer.goes_on(); }};
    return app::run_whole_study(std::move(study), std::move(members), folder, wanted.share,
                                [&](const app::Study& grown, const std::vector<app::Member>& all) {
                                  return app::run_members(grown, folder, all, wanted.jobs, watch);
                                });
  });
}

void close(const Breakings& breakings) {
  std::ostringstream nowhere;
  app::Console console{nowhere, nowhere, false, true, {}};
  (void)app::close_study(breakings.folder, breakings.whole.study, breakings.whole.members,
                         *breakings.whole.results, console);
}

void study_conclude(const BreakingsPointer& breakings, const Wanted& wanted, const Spectator& spectator) {
  const app::StudyTally& tally = breakings->whole.tally;
  spectator.conclude(fmt::format("interrupted; {} of {} members are done or have failed, and are kept; the "
                                 "same call goes on",
                                 tally.all - tally.open(), tally.all),
                     py::cast(breakings));
  if (wanted.share > 0 && tally.open() == 0 && !(breakings->whole.half_width() <= wanted.share))
    raise_with({app::Exit::data,
                app::complaint("until_ci", fmt::format("{}", wanted.share),
                               fmt::format("not met with {} seeds", breakings->whole.study.plan.seeds.size()),
                               "choose a larger share")},
               py::cast(breakings));
}

void check_seeds(const Wanted& wanted, const app::Study& study) {
  if (wanted.share > 0 && study.plan.seeds.empty())
    throw app::Rejected(app::Exit::usage, "until_ci", fmt::format("{}", wanted.share),
                        "needs a study with seeds", "give seeds = 10");
}

BreakingsPointer study(const py::object& input, const py::dict& settings, const py::dict& options,
                       const py::dict& what, const py::object& output, const py::object& jobs,
                       const py::object& until_ci, bool retry, const py::object& progress) {
  return located(with_output("output"), [&] {
    const Wanted wanted = wanted_of(jobs, until_ci, retry);
    const app::StudyFolder folder(path_text(output));
    StudyWish wish = read_wish({input, settings, options, what}, folder.path());
    check_seeds(wanted, wish.study);
    std::vector<app::Member> members = list_members(wish.study);
    const app::CheckedScenes checked = check_scenes(wish.study, members);
    warn_of_doubts(checked.doubts);
    folder.open(wish.study, members);
    wish.keep();
    if (wanted.retry)
      for (const app::Member& member : members) folder.forget_failure(member);
    warn_of_length(announcement(folder, members, checked.sizes, wanted.jobs));
    Spectator spectator(progress);
    auto breakings = std::make_shared<Breakings>(
        Breakings{folder, run(folder, std::move(wish.study), std::move(members), wanted, spectator), {}});
    app::WholeStudy& whole = breakings->whole;
    const bool ended = whole.results.has_value();
    if (!ended) whole.results = read_results(folder, whole.members);
    if (ended) close(*breakings);
    breakings->table = study_table(whole.study, whole.members, *whole.results);
    study_conclude(breakings, wanted, spectator);
    return breakings;
  });
}

const Breakings& breakings_of(const py::object& self) { return self.cast<const Breakings&>(); }

template <class T>
py::array column(const std::vector<T>& values, const py::object& owner) {
  return view(values, owner);
}
py::array column(const std::vector<std::string>& values, const py::object& /*owner*/) {
  return py::module_::import("numpy").attr("array")(py::cast(values), py::arg("dtype") = "object");
}

py::dict table(const py::object& self) {
  py::dict columns;
  for (const mpm::TableColumn& one : breakings_of(self).table)
    columns[py::str(one.name)] =
        std::visit([&](const auto& values) { return column(values, self); }, one.values);
  return columns;
}

py::dict units(const Breakings& breakings) {
  py::dict units;
  for (const mpm::TableColumn& one : breakings.table) units[py::str(one.name)] = one.unit;
  return units;
}

py::list study_curves(const py::object& self) {
  py::list all;
  for (const app::Curve& curve : breakings_of(self).whole.results->curves)
    all.append(curve.empty() ? py::none() : curve_of(view(curve.strain, self), view(curve.stress, self)));
  return all;
}

py::dict failures(const Breakings& breakings) {
  py::dict reasons;
  const auto& outcomes = breakings.whole.results->outcomes;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (outcomes[i].state == app::MemberState::failed) reasons[py::int_(i)] = outcomes[i].reason;
  return reasons;
}

std::string study_representation(const Breakings& breakings) {
  const app::StudyResults& results = *breakings.whole.results;
  std::string text = fmt::format("<mesopix.Study: {} of {} members done",
                                 results.count(app::MemberState::done), results.outcomes.size());
  if (const std::size_t failed = results.count(app::MemberState::failed); failed > 0)
    text += fmt::format(", {} failed", failed);
  return text + "; in " + breakings.folder.path().string() + ">";
}

}  // namespace

void bind_study(py::module_& module) {
  py::class_<Breakings, BreakingsPointer>(
      module, "Study", "What many runs of a scene came to. Its arrays are read-only, and keep it alive.")
      .def_property_readonly(
          "table", &table,
          "{column: array}, an entry a member, as table.csv and in SI units: table[\"peak_stress\"] [Pa]; "
          "pandas.DataFrame(study.table) takes it")
      .def_property_readonly("units", &units, "{column: SI unit}; \"1\" for none")
      .def_property_readonly(
          "curves", &study_curves,
          "Curve(strain [-], stress [Pa]) of each member, some 200 points; None of one that is not done")
      .def_property_readonly(
          "crack_counts",
          [](const py::object& self) {
            return view(breakings_of(self).whole.results->cracks.failures, self);
          },
          "how many members had the point of a pixel fail, int32 of shape (rows, columns), row 0 on top; "
          "None "
          "where they have no common picture")
      .def_property_readonly("failures", &failures, "{number of a member that has failed: why}")
      .def_property_readonly(
          "half_width", [](const Breakings& breakings) { return breakings.whole.half_width(); },
          "of the 95 % confidence interval of the mean peak stress over that mean, the largest of all points "
          "[-]; NaN where it is not known")
      .def_property_readonly(
          "folder", [](const Breakings& breakings) { return breakings.folder.path().string(); },
          "that holds the members, the tables and report.html")
      .def("__len__", [](const Breakings& breakings) { return breakings.whole.members.size(); })
      .def("__repr__", &study_representation);
  module.def("study", &study);
}

}  // namespace binding
