#include "apps/run/run_task.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "apps/command/program.hpp"
#include "apps/system/files.hpp"
#include "libmpm/files/result_file.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace run_task_test {

namespace fs = std::filesystem;
using app::Exit;
using testing::HasSubstr;
using testing::Not;

/// Writes down what it is given, and raises a signal when the progress line is drawn for the first time, or
/// the first time after a text.
class Interrupting : public std::stringbuf {
 public:
  bool armed = false;
  std::string after;

 protected:
  int sync() override {
    const std::size_t begin = str().find(after);
    if (armed && begin != std::string::npos && str().find('\r', begin) != std::string::npos) {
      armed = false;
      std::raise(SIGTERM);
    }
    return std::stringbuf::sync();
  }
};

/// Runs the program in a folder of its own that holds a small scene.
class Resumption : public testing::Test {
 protected:
  void SetUp() override {
    fs::current_path(folder_ / "");
    test::write_text("scene.toml",
                     "[generate]\nwidth = \"32 mm\"\nheight = \"32 mm\"\npixel_size = \"1 mm\"\n"
                     "fraction = 0.3\nd_min = \"4 mm\"\nd_max = \"8 mm\"\n[output]\nhistory_rows = 50\n");
  }
  void TearDown() override { fs::current_path(before_); }

  Exit simulate(std::vector<std::string> arguments) {
    out_.str("");
    said_.str("");
    arguments.insert(arguments.begin(), "simulate");
    std::ostream err(&said_);
    app::Console console{out_, err, terminal_, false, {}};
    return app::run_program(arguments, console);
  }
  std::string said() const { return said_.str(); }

  /// Interrupted at its first row, where the progress line is drawn for the first time.
  void interrupt(std::vector<std::string> arguments) {
    terminal_ = said_.armed = true;
    ASSERT_EQ(simulate(std::move(arguments)), Exit::interrupted) << said();
    terminal_ = said_.armed = false;
  }
  void expect_refusal(const std::vector<std::string>& arguments, Exit code, const std::string& message) {
    EXPECT_EQ(simulate(arguments), code) << said();
    EXPECT_EQ(said(), "mesopix: " + message + "\n");
  }
  static std::set<std::string> files(const std::string& folder) {
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      found.insert(fs::relative(entry.path(), folder));
    return found;
  }
  static std::string checkpoint_in(const std::string& run) {
    return fs::directory_iterator(run + "/checkpoints")->path();
  }
  static nlohmann::json summary_of(const std::string& run) {
    return nlohmann::json::parse(test::read_text(run + "/summary.json"));
  }

  std::ostringstream out_;
  Interrupting said_;
  bool terminal_ = false;

 private:
  fs::path before_ = fs::current_path();
  test::TemporaryFolder folder_;
};

TEST_F(Resumption, EndsAsTheRunThatNeverStopped) {
  ASSERT_EQ(simulate({"scene.toml", "-o", "whole", "--frames", "4"}), Exit::ok) << said();
  interrupt({"scene.toml", "-o", "run", "--frames", "4", "--threads", "1"});
  EXPECT_THAT(said(), HasSubstr("interrupted; what was computed is kept\n"
                                "to go on: mesopix simulate --resume run\n"));
  EXPECT_NE(test::read_text("run/curve.csv"), test::read_text("whole/curve.csv"));
  ASSERT_EQ(simulate({"--resume", "run", "--threads", "2", "--json"}), Exit::ok) << said();
  EXPECT_THAT(said(), HasSubstr("goes on at 0 %, step "));
  EXPECT_EQ(files("run"), files("whole")) << "no checkpoint is left, no frame too many";
  for (const char* file :
       {"curve.csv", "damage_100.png", "frames.hdf.series", "frames.xdmf", "frames/p_000003.hdf"})
    EXPECT_EQ(test::read_text(std::string("run/") + file), test::read_text(std::string("whole/") + file))
        << file;
  nlohmann::json ended = nlohmann::json::parse(out_.str()), whole = summary_of("whole");
  EXPECT_EQ(ended["peak_stress_Pa"], whole["peak_stress_Pa"]);
  EXPECT_EQ(ended["steps"], whole["steps"]);
  ASSERT_EQ(simulate({"--resume", "run"}), Exit::ok) << said();
  EXPECT_EQ(said(), "the run in run has come to its end, there is nothing to go on with\n");
}

TEST_F(Resumption, NeedsNothingButTheFolder) {
  fs::create_directory("other");
  interrupt({"scene.toml", "-o", "other/run"});
  fs::remove("scene.toml");
  fs::rename("other/run", "moved");
  fs::remove("moved/scene.toml");
  ASSERT_EQ(simulate({"--resume", "moved"}), Exit::ok) << said();
  EXPECT_TRUE(fs::exists("moved/scene.toml"));
}

TEST_F(Resumption, StaysWithWhatWasAskedFor) {
  interrupt({"scene.toml", "-o", "run", "--estimate-error", "--checkpoint-every", "1 h"});
  interrupt({"--resume", "run"});
  ASSERT_EQ(simulate({"--resume", "run"}), Exit::ok) << said();
  EXPECT_THAT(said(), HasSubstr("the peak stress may be wrong by "));
  EXPECT_EQ(summary_of("run")["error_estimate"]["sources"].size(), 4U);
}

TEST_F(Resumption, KeepsWhatAToleranceChose) {
  said_.after = "a tolerance of 30 % is met at ";
  interrupt({"scene.toml", "-o", "run", "--tolerance", "30 %"});
  ASSERT_EQ(simulate({"--resume", "run"}), Exit::ok) << said();
  EXPECT_EQ(summary_of("run")["precision"], "single");
  EXPECT_EQ(summary_of("run")["error_estimate"]["sources"].size(), 3U);
  ASSERT_EQ(simulate({"run/scene.toml", "-o", "whole"}), Exit::ok) << said();
  EXPECT_EQ(test::read_text("run/curve.csv"), test::read_text("whole/curve.csv"));
}

TEST_F(Resumption, WritesCheckpointsOnTheWay) {
  ASSERT_EQ(simulate({"scene.toml", "-o", "run", "--checkpoint-every", "1 us"}), Exit::ok) << said();
  EXPECT_THAT(said(), HasSubstr(" written in 0."));
  EXPECT_FALSE(fs::exists("run/checkpoints")) << "a run that is over needs none";
  ASSERT_EQ(simulate({"scene.toml", "-o", "plain"}), Exit::ok) << said();
  EXPECT_THAT(said(), Not(HasSubstr("checkpoint")));
  EXPECT_EQ(test::read_text("run/curve.csv"), test::read_text("plain/curve.csv"));
}

TEST_F(Resumption, TakesTheOneBeforeADamagedOne) {
  interrupt({"scene.toml", "-o", "run"});
  const std::string first = checkpoint_in("run"), kept = "kept";
  fs::copy(first, kept);
  interrupt({"--resume", "run"});
  ASSERT_EQ(files("run/checkpoints").size(), 2U);
  std::string second = first;
  for (const std::string& name : files("run/checkpoints"))
    if ("run/checkpoints/" + name != first) second = "run/checkpoints/" + name;
  test::write_text(second, test::read_text(second).substr(0, 5000));
  ASSERT_EQ(simulate({"--resume", "run"}), Exit::ok) << said();
  EXPECT_THAT(said(), HasSubstr("warning: " + second + ": is damaged: its digest does not match its bytes"));
  EXPECT_THAT(said(), HasSubstr(", from " + first));
  ASSERT_EQ(simulate({"scene.toml", "-o", "whole"}), Exit::ok) << said();
  EXPECT_EQ(test::read_text("run/curve.csv"), test::read_text("whole/curve.csv"));
}

TEST_F(Resumption, RefusesARunWithoutACheckpoint) {
  interrupt({"scene.toml", "-o", "run"});
  test::write_text(checkpoint_in("run"), "damaged");
  EXPECT_EQ(simulate({"--resume", "run"}), Exit::data);
  EXPECT_THAT(said(),
              HasSubstr("mesopix: --resume: run has no checkpoint that can be read; begin the run anew\n"));
  fs::remove(checkpoint_in("run"));
  const std::string none = "has no checkpoint; begin the run anew, with --checkpoint-every to have some";
  expect_refusal({"--resume", "run"}, Exit::data, "--resume: run " + none);
  fs::create_directory("empty");
  expect_refusal({"--resume", "empty"}, Exit::data, "--resume: empty " + none);
  expect_refusal({"--resume", "none"}, Exit::usage, "--resume: none; must be the folder of a run");
  expect_refusal({"--resume", "scene.toml"}, Exit::usage,
                 "--resume: scene.toml; must be the folder of a run");
}

TEST_F(Resumption, RefusesAFolderThatAnotherProgramWrites) {
  interrupt({"scene.toml", "-o", "run"});
  const std::set<std::string> before = files("run");
  {
    const app::HeldFolder other("run");
    const std::string why =
        "mesopix: run: another program is writing a run there; wait until it has ended, or choose another "
        "folder\n";
    EXPECT_EQ(simulate({"--resume", "run"}), Exit::interrupted);
    EXPECT_THAT(said(), HasSubstr(why));
    EXPECT_EQ(simulate({"scene.toml", "-o", "run", "--overwrite"}), Exit::interrupted);
    EXPECT_THAT(said(), HasSubstr(why));
  }
  EXPECT_EQ(files("run"), before) << "its checkpoint is as it was";
  EXPECT_EQ(simulate({"--resume", "run", "--quiet"}), Exit::ok) << said();
}

TEST_F(Resumption, RefusesAnotherSceneWithWhatDiffers) {
  interrupt({"scene.toml", "-o", "run", "--frames", "2"});
  const std::string cure = "; take that back, or begin another run";
  expect_refusal({"--resume", "run", "--velocity", "0.1 m/s"}, Exit::data,
                 "--velocity: '0.1 m/s'; the run began with '0.05 m/s'" + cure);
  expect_refusal({"--resume", "run", "--set", "damage.seed=7"}, Exit::data,
                 "--set damage.seed: 7; the run began with 1" + cure);
  std::string text = test::read_text("run/scene.toml");
  const std::string good = text;
  text.replace(text.find("tensile_scale = \"15 MPa\""), 24, "tensile_scale = \"14 MPa\"");
  test::write_text("run/scene.toml", text);
  EXPECT_EQ(simulate({"--resume", "run"}), Exit::data);
  EXPECT_THAT(said(), HasSubstr("phases.mortar.tensile_scale: '14 MPa'; the run began with '15 MPa'" + cure));
  EXPECT_THAT(said(), HasSubstr("mesopix: run/scene.toml:"));
  test::write_text("run/scene.toml", "# a comment\n" + good);
  const std::string frame = "run/frames/p_000000.hdf";
  fs::rename(frame, "frame");
  EXPECT_EQ(simulate({"--resume", "run"}), Exit::io);
  EXPECT_THAT(said(),
              HasSubstr("mesopix: " + frame + ": of the run that is to go on is missing; bring it back"));
  fs::rename("frame", frame);
  ASSERT_EQ(simulate({"scene.toml", "-o", "seven", "--generate.seed", "7"}), Exit::ok);
  fs::rename("run/specimen.h5", "specimen.h5");
  fs::copy("seven/specimen.h5", "run/specimen.h5");
  expect_refusal({"--resume", "run"}, Exit::data,
                 "run/specimen.h5: is not the specimen that the run began with; bring it back as it was");
  fs::rename("specimen.h5", "run/specimen.h5");
  EXPECT_EQ(simulate({"--resume", "run", "--velocity", "0.05 m/s", "--threads", "1"}), Exit::ok)
      << "what is the same may be said again: " << said();
}

TEST_F(Resumption, RefusesWhatDoesNotGoTogether) {
  const auto expect = [&](std::vector<std::string> with, const std::string& other) {
    with.insert(with.begin(), {"--resume", "run"});
    expect_refusal(with, Exit::usage, "--resume: given with " + other + "; give one of the two");
  };
  expect({"scene.toml"}, "INPUT");
  expect({"-o", "x"}, "--output");
  expect({"--overwrite"}, "--overwrite");
  expect({"--print-scene"}, "--print-scene");
  expect({"--explain"}, "--explain");
  expect({"--estimate-error"}, "--estimate-error");
  expect({"--tolerance", "1 %"}, "--tolerance");
  for (const char* every : {"0 s", "-1 s"})
    expect_refusal({"scene.toml", "--checkpoint-every", every}, Exit::usage,
                   std::string("--checkpoint-every: ") + every + "; must be > 0");
  expect_refusal({"scene.toml", "--checkpoint-every", "60"}, Exit::usage,
                 "--checkpoint-every: 60; needs a unit; write e.g. \"0.1 ms\"");
  expect_refusal({"--resume", "run", "--checkpoint-every", "soon"}, Exit::usage,
                 "--checkpoint-every: soon; must be a time, e.g. \"0.1 ms\"");
}

}  // namespace run_task_test
