#include "apps/study/study_sections.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/study/study_report.hpp"
#include "apps/study/study_values.hpp"
#include "tests/apps/small_study.hpp"

namespace study_sections_test {

using namespace app;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A study whose members were never run: their peaks are made up.
class StudySections : public testing::Test {
 protected:
  template <class Peak>
  StudyRecord record(const std::string& text, Peak peak) {
    study_ = test::small_study(folder_, text);
    members_ = list_members(study_);
    results_ = {};
    for (const Member& member : members_) {
      results_.outcomes.emplace_back().state = MemberState::done;
      results_.outcomes.back().figures.peak_stress = peak(member);
      results_.outcomes.back().figures.peak_strain = 1e-4;
      results_.curves.push_back({{0, 1e-4, 2e-4}, {0, peak(member), 0}});
    }
    return {study_, members_, results_, {}, {}};
  }

  test::TemporaryFolder folder_;
  Study study_;
  std::vector<Member> members_;
  StudyResults results_;
};

TEST_F(StudySections, SeedsAloneHaveADistribution) {
  const StudyRecord seeds = record("seeds = 12\n", [](const Member& member) {
    return 3e6 + 1e5 * std::sin(static_cast<double>(member.number));
  });
  EXPECT_THAT(peaks_section(seeds),
              AllOf(HasSubstr("Mean peak stress"), HasSubstr("95 % confidence interval")));
  EXPECT_THAT(weibull_section(seeds), HasSubstr("Weibull modulus"));
  EXPECT_THAT(
      convergence_section(seeds),
      HasSubstr(
          "With 12 members the mean is known to ± 1.6\u00a0%. To know it to ± 2\u00a0% takes about 9."));
  EXPECT_EQ(sensitivity_section(seeds), "");
  EXPECT_EQ(size_section(seeds), "");
}

TEST_F(StudySections, ParametersHaveInfluences) {
  const StudyRecord vary = record(
      "sampling = \"sobol\"\nsamples = 31\n[vary]\n"
      "\"phases.mortar.tensile_scale\" = {low = \"10 MPa\", high = \"20 MPa\"}\n"
      "\"solver.cfl\" = {low = 0.5, high = 0.8}\n",
      [&](const Member& member) { return 0.2 * number_of(study_.plan.parameters[0], member.values[0]); });
  EXPECT_EQ(weibull_section(vary), "");
  EXPECT_EQ(convergence_section(vary), "");
  EXPECT_THAT(peaks_section(vary), HasSubstr("phases.mortar.tensile_scale"));
  const std::string html = sensitivity_section(vary);
  EXPECT_THAT(html, HasSubstr("Peak stress against solver.cfl"));
  const std::string table = html.substr(html.find("<table"));
  const std::size_t first = table.find("phases.mortar.tensile_scale"), second = table.find("solver.cfl");
  EXPECT_THAT(table.substr(first, second - first), AllOf(HasSubstr(">1.0<"), HasSubstr("&lt; 0.001")));
  EXPECT_THAT(table.substr(second), Not(HasSubstr("&lt; 0.001")));
}

TEST_F(StudySections, SizesHaveALawThatMayNotFit) {
  const std::string text =
      "seeds = 2\n[vary]\n\"generate.width+generate.height\" = [\"20 mm\", \"40 mm\", \"80 mm\"]\n";
  const auto size = [&](const Member& member) {
    return number_of(study_.plan.parameters[0], member.values[0]);
  };
  EXPECT_THAT(
      size_section(record(text, [&](const Member& m) { return 4e6 / std::sqrt(1 + size(m) / 0.05); })),
      AllOf(HasSubstr("50.0"), HasSubstr("explains most of the variance")));
  EXPECT_THAT(size_section(record(text, [&](const Member& m) { return 3e6 + 1e7 * size(m); })),
              HasSubstr("no size at which plasticity gives way to fracture"));
  const auto scattered = [&](const Member& m) {
    return 4e6 / std::sqrt(1 + size(m) / 0.3) + (m.number < 3 ? 5e5 : -5e5);
  };
  EXPECT_THAT(size_section(record(text, scattered)), HasSubstr("less than half of the variance"));
  EXPECT_TRUE(varies_pixels(study_.plan));
}

TEST_F(StudySections, TellsOfEnergiesThatAreOff) {
  const StudyRecord off = record("seeds = 12\n", [](const Member&) { return 3e6; });
  results_.outcomes[4].figures.energy_error = 0.005;
  EXPECT_THAT(study_html(off, ""), Not(HasSubstr("Notes")));
  results_.outcomes[7].figures.energy_error = 0.05;
  EXPECT_THAT(study_html(off, ""), HasSubstr("The energies of member 7 (seed 8) are the worst: the ledger of "
                                             "energies is off by 5 % of the platen work"));
}

TEST_F(StudySections, TellsOfFailuresAndOfNothingElseWhenAllFailed) {
  StudyRecord failed = record("seeds = 12\n", [](const Member&) { return 3e6; });
  for (MemberOutcome& outcome : results_.outcomes) outcome = {MemberState::failed, "it <broke>", {}, {}};
  results_.curves.assign(12, {});
  const std::string html = study_html(failed, "");
  EXPECT_THAT(html, AllOf(HasSubstr("12 members failed"), HasSubstr("it &lt;broke&gt;"), HasSubstr("2 more"),
                          Not(HasSubstr("<h2>Peaks"))));
}

}  // namespace study_sections_test
