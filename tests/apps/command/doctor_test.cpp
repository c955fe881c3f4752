#include "apps/command/doctor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/apps/program_in_folder.hpp"

namespace doctor_test {

using app::Exit;
using app::Health;
using testing::HasSubstr;
using testing::IsEmpty;

/// A machine that all is well with.
app::Examination healthy() {
  app::Examination it;
  it.build = {"GCC 12.2.0", "Release", false};
  it.machine = {"Some processor", 8, 6, 0, {"avx2", "baseline"}, 16'000'000'000, 12'000'000'000,
                16'000'000'000};
  it.libraries = {{"HDF5", "1.10.8"}, {"OpenCV", "4.6.0"}};
  it.folder = "/home/me";
  it.free_disk = 50'000'000'000;
  it.has_terminal = true;
  it.terminal = {"de_DE.UTF-8", "xterm", false};
  it.self_test = {1e-3, 1e-4, true, 6, 4e8, 0.3};
  return it;
}

std::string unwell(const std::function<void(app::Examination&)>& change) {
  app::Examination it = healthy();
  change(it);
  return app::findings_text(app::unwell(app::findings_of(it)));
}

Exit code(const std::function<void(app::Examination&)>& change) {
  app::Examination it = healthy();
  change(it);
  return app::code_of(app::findings_of(it));
}

TEST(Doctor, SaysOfEachTopicThatAllIsWell) {
  EXPECT_THAT(unwell([](auto&) {}), IsEmpty());
  EXPECT_EQ(code([](auto&) {}), Exit::ok);
  const std::string text = app::findings_text(app::findings_of(healthy()));
  EXPECT_THAT(text, HasSubstr("ok       processor  Some processor, runs avx2 and baseline; avx2 is used\n"));
  EXPECT_THAT(text, HasSubstr("ok       threads    8 cores, 6 idle; a run takes up to 6 threads\n"));
  EXPECT_THAT(text, HasSubstr("16.0 GB, 12.0 GB free; a run may take 16.0 GB\n"));
  EXPECT_THAT(text, HasSubstr("50.0 GB free in /home/me\n"));
  EXPECT_THAT(text, HasSubstr("HDF5 1.10.8, OpenCV 4.6.0\n"));
  EXPECT_THAT(text, HasSubstr("UTF-8 (de_DE.UTF-8), with colours\n"));
  EXPECT_THAT(text,
              HasSubstr("400 million point-updates a second on one core, 30 % of what it can do at most\n"));
}

TEST(Doctor, WarnsWithACure) {
  EXPECT_THAT(unwell([](auto& it) { it.build.type = "Debug"; }),
              HasSubstr("runs are many times slower than they could be; cmake --preset release\n"));
  EXPECT_THAT(unwell([](auto& it) { it.build.sanitized = true; }), HasSubstr("with a sanitizer"));
  EXPECT_THAT(unwell([](auto& it) { it.machine.cores = it.machine.idle_cores = 1; }),
              HasSubstr("warning  threads    1 core, 1 idle; a run takes up to 1 thread;"));
  EXPECT_THAT(unwell([](auto& it) { it.machine.idle_cores = 1; }), HasSubstr("end other programs"));
  EXPECT_THAT(unwell([](auto& it) { it.machine.quota = 2.5; }),
              HasSubstr("8 cores, and the container may use the time of 2.5; give --threads 2 to simulate"));
  EXPECT_THAT(unwell([](auto& it) { it.machine.free_memory = 100'000'000; }), HasSubstr("warning  memory"));
  EXPECT_THAT(unwell([](auto& it) { it.machine.memory_limit = 100'000'000; }), HasSubstr("warning  memory"));
  EXPECT_THAT(unwell([](auto& it) { it.free_disk = 100'000'000; }),
              HasSubstr("warning  disk       0.1 GB free in"));
  EXPECT_THAT(unwell([](auto& it) { it.terminal.locale = "C"; }), HasSubstr("export LC_ALL=C.UTF-8"));
  EXPECT_THAT(unwell([](auto& it) { it.self_test.share_of_peak = 1e-3; }), HasSubstr("warning  speed"));
  EXPECT_EQ(code([](auto& it) { it.free_disk = 0; }), Exit::ok);
}

TEST(Doctor, FailsWhereNothingCanBeDone) {
  const auto read_only = [](auto& it) { it.why_not_writable = "Permission denied"; };
  EXPECT_THAT(unwell(read_only),
              HasSubstr("failed   disk       /home/me cannot be written to: Permission denied; go"));
  EXPECT_EQ(code(read_only), Exit::io);
  const auto wrong_modulus = [](auto& it) { it.self_test.modulus_error = 0.02; };
  EXPECT_THAT(unwell(wrong_modulus), HasSubstr("the modulus of an elastic block is 2 % off"));
  EXPECT_EQ(code(wrong_modulus), Exit::internal);
  EXPECT_EQ(code([](auto& it) { it.self_test.peak_error = std::nan(""); }), Exit::internal);
  EXPECT_THAT(unwell([](auto& it) { it.self_test.same_on_threads = false; }),
              HasSubstr("6 threads give other bits"));
  EXPECT_EQ(code([](auto& it) {
              it.self_test.same_on_threads = false;
              it.why_not_writable = "Permission denied";
            }),
            Exit::internal);
}

TEST(Doctor, GivesFindingsAndFiguresAsJson) {
  const app::Examination it = healthy();
  const auto json = app::examination_json(it, app::findings_of(it));
  EXPECT_EQ(json["ready"], true);
  EXPECT_EQ(json["findings"][0]["topic"], "program");
  EXPECT_EQ(json["findings"][0]["health"], "ok");
  EXPECT_EQ(json["findings"][0]["cure"], nullptr);
  EXPECT_EQ(json["figures"]["free_disk_B"], 50'000'000'000);
  EXPECT_EQ(json["figures"]["quota_cores"], nullptr);
}

TEST(Machine, ReadsTheQuotaOfAContainer) {
  EXPECT_EQ(app::quota_of("150000 100000"), 1.5);
  EXPECT_EQ(app::quota_of("max 100000"), 0);
  EXPECT_EQ(app::quota_of(""), 0);
  const app::Machine machine = app::this_machine();
  EXPECT_GE(machine.cores, machine.idle_cores);
  EXPECT_GE(machine.memory, machine.free_memory);
  EXPECT_GT(machine.free_memory, 0u);
  EXPECT_EQ(machine.instruction_sets.back(), "baseline");
}

TEST(Machine, SaysWhyAFolderCannotBeWrittenTo) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(app::why_not_writable(folder / ""), "");
  EXPECT_EQ(app::why_not_writable("/nothing/there"), "No such file or directory");
  EXPECT_THROW((void)app::free_disk("/nothing/there"), app::Rejected);
}

TEST(TerminalEnvironment, KnowsUtf8) {
  for (const char* locale : {"C.UTF-8", "en_US.utf8", "de_DE.UTF-8@euro"})
    EXPECT_TRUE((app::TerminalEnvironment{locale, "xterm", false}.is_utf8())) << locale;
  EXPECT_FALSE((app::TerminalEnvironment{"POSIX", "xterm", false}.is_utf8()));
  EXPECT_FALSE((app::TerminalEnvironment{"C.UTF-8", "dumb", false}.has_colours()));
  EXPECT_FALSE((app::TerminalEnvironment{"C.UTF-8", "xterm", true}.has_colours()));
}

class DoctorCommand : public test::ProgramInFolder {
 protected:
  DoctorCommand() : ProgramInFolder("doctor") {}
};

TEST_F(DoctorCommand, FindsTheNumbersRightAndLeavesNothing) {
  ASSERT_EQ(run({"--json"}), Exit::ok) << out_.str();
  const auto json = nlohmann::json::parse(out_.str());
  EXPECT_EQ(json["ready"], true);
  EXPECT_EQ(json["figures"]["same_on_threads"], true);
  EXPECT_GT(json["figures"]["point_updates_per_second"].get<double>(), 1e5);
  EXPECT_GT(json["figures"]["share_of_peak"].get<double>(), 0);
  EXPECT_LT(json["figures"]["share_of_peak"].get<double>(), 1);
  for (const char* library : {"HDF5", "OpenCV", "libpng", "libtiff"})
    EXPECT_THAT(json["figures"]["libraries"][library].get<std::string>(),
                testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+.*"))
        << library;
  EXPECT_TRUE(std::filesystem::is_empty("."));
}

}  // namespace doctor_test
