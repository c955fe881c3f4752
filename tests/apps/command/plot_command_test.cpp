#include "apps/command/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/apps/program_in_folder.hpp"

namespace plot_command_test {

namespace fs = std::filesystem;
using app::Exit;
using testing::HasSubstr;
using testing::StartsWith;

/// Runs the program in a folder of its own that holds the run `run`, which ends before its peak.
class PlotCommand : public test::ProgramInFolder {
 protected:
  void SetUp() override {
    test::write_text(
        "scene.toml",
        "[generate]\nwidth = \"20 mm\"\nheight = \"20 mm\"\npixel_size = \"1 mm\"\nfraction = 0.3\n"
        "d_min = \"4 mm\"\nd_max = \"8 mm\"\n[loading]\nstop_strain = 20e-6\n");
    ASSERT_EQ(call({"simulate", "scene.toml", "-o", "run", "--frames", "4"}), Exit::ok) << err_.str();
  }

  static std::string content(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(PlotCommand, DrawsTheDamageInEveryFormat) {
  for (const auto& [file, begins] :
       {std::pair{"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}, {"a.PDF", "%PDF"}}) {
    EXPECT_EQ(call({"plot", "run", "-o", file}), Exit::ok) << err_.str();
    EXPECT_THAT(content(file), StartsWith(begins)) << file;
  }
  EXPECT_EQ(call({"plot", "run"}), Exit::ok);
  EXPECT_TRUE(fs::exists("damage.png"));
}

TEST_F(PlotCommand, OptionsChangeThePicture) {
  const auto drawn = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"plot", "run", "-o", "one.png"});
    EXPECT_EQ(call(options), Exit::ok) << err_.str();
    return content("one.png");
  };
  const std::string first = drawn({});
  EXPECT_EQ(drawn({"--at", "100%peak", "--look", "grey", "--what", "damage"}), first);
  EXPECT_NE(drawn({"--at", "10e-6"}), first);
  EXPECT_NE(drawn({"--look", "colour"}), first);
  EXPECT_NE(drawn({"--what", "curve"}), first);
  EXPECT_EQ(drawn({"--at", "50 %peak"}), drawn({"--at", "0.5peak"}));
}

TEST_F(PlotCommand, DrawsTheStressOfAFrame) {
  const auto drawn = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"plot", "run", "--what", "stress", "-o", "one.png"});
    EXPECT_EQ(call(options), Exit::ok) << err_.str();
    return content("one.png");
  };
  const std::string first = drawn({});
  EXPECT_THAT(first, StartsWith("\x89PNG"));
  EXPECT_THAT(out_.str() + err_.str(), HasSubstr("wrote one.png: p_00000"));
  EXPECT_EQ(drawn({"--component", "yy", "--range", "auto", "--at", "100%peak"}), first);
  std::set<std::string> all{first};
  for (const char* component : {"xx", "xy", "first", "third", "mises"})
    EXPECT_TRUE(all.insert(drawn({"--component", component})).second) << component;
  EXPECT_TRUE(all.insert(drawn({"--range", "-5:5 MPa"})).second);
  EXPECT_TRUE(all.insert(drawn({"--at", "10e-6"})).second);
  EXPECT_THAT(out_.str() + err_.str(), HasSubstr("p_000002.hdf, at 10.1 microstrain"));
}

TEST_F(PlotCommand, TellsWhatItDrewAsJsonAndIsQuiet) {
  ASSERT_EQ(call({"plot", "run", "--at", "10e-6", "--json", "-q"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "");
  EXPECT_EQ(nlohmann::json::parse(out_.str()),
            (nlohmann::json{{"files", {"damage.png"}}, {"what", "damage"}, {"strain", 10e-6}}));
  ASSERT_EQ(call({"plot", "run", "--what", "stress", "--json"}), Exit::ok) << err_.str();
  EXPECT_THAT(nlohmann::json::parse(out_.str())["frame"].get<std::string>(), StartsWith("p_00000"));
  EXPECT_THAT(err_.str(), StartsWith("wrote stress.png: p_00000"));
}

TEST_F(PlotCommand, RefusesOptionsThatWouldChangeNothing) {
  const auto refusal = [&](const char* what, const char* option, const char* value) {
    EXPECT_EQ(call({"plot", "run", "--what", what, option, value}), Exit::usage);
    return err_.str();
  };
  EXPECT_THAT(refusal("damage", "--component", "yy"),
              HasSubstr("--component: yy; changes nothing of --what damage; is for stress"));
  EXPECT_THAT(refusal("damage", "--range", "auto"), HasSubstr("is for stress"));
  EXPECT_THAT(refusal("stress", "--look", "grey"), HasSubstr("is for damage"));
  EXPECT_THAT(refusal("curve", "--at", "1e-5"), HasSubstr("is for damage or stress"));
}

TEST_F(PlotCommand, RefusesWhatItCannotDraw) {
  const auto refusal = [&](std::vector<std::string> options, Exit code) {
    options.insert(options.begin(), "plot");
    EXPECT_EQ(call(options), code) << err_.str();
    return err_.str();
  };
  EXPECT_THAT(refusal({}, Exit::usage), HasSubstr("RUN: missing"));
  EXPECT_THAT(refusal({"run", "--at", "30e-6"}, Exit::data),
              HasSubstr("--at: 30e-6; must be from 0 to 20.2 microstrain, where the run ended"));
  EXPECT_THAT(refusal({"run", "--at", "-1e-6"}, Exit::data), HasSubstr("must be from 0"));
  EXPECT_THAT(refusal({"run", "--at", "soon"}, Exit::usage), HasSubstr("--at: soon"));
  EXPECT_THAT(refusal({"run", "--what", "strain"}, Exit::usage),
              HasSubstr("must be damage, stress or curve"));
  EXPECT_THAT(refusal({"run", "--what", "stress", "--component", "zz"}, Exit::usage),
              HasSubstr("--component: zz; must be yy, xx, xy, first, third or mises"));
  EXPECT_THAT(refusal({"run", "--what", "stress", "--range", "high"}, Exit::usage),
              HasSubstr("--range: high"));
  EXPECT_THAT(refusal({"run", "--what", "stress", "--at", "30e-6"}, Exit::data),
              HasSubstr("where the run ended"));
  EXPECT_THAT(refusal({"run", "--look", "red"}, Exit::usage), HasSubstr("must be grey or colour"));
  EXPECT_THAT(refusal({"run", "-o", "a.gif"}, Exit::usage), HasSubstr("must be .png, .svg or .pdf"));
  EXPECT_THAT(refusal({"nowhere"}, Exit::io), HasSubstr("nowhere"));
  test::write_text("run/frames/p_000000.hdf", "no frame");
  EXPECT_THAT(refusal({"run", "--what", "stress"}, Exit::io),
              HasSubstr("frames/p_000000.hdf: is not an HDF5 file, or is cut short or damaged"));
  fs::remove_all("run/frames");
  EXPECT_THAT(refusal({"run", "--what", "stress"}, Exit::data),
              HasSubstr("RUN: run; has no frames, which hold the stress; run it again with --frames 40"));
}

}  // namespace plot_command_test
