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

/// Runs the program in a folder of its own that holds the run `run`, which ends before its peak, so that
/// pictures show it at its largest stress.
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
  EXPECT_EQ(drawn({"--look", "grey", "--what", "damage"}), first);
  EXPECT_NE(drawn({"--at", "10e-6"}), first);
  EXPECT_NE(drawn({"--look", "colour"}), first);
  EXPECT_NE(drawn({"--what", "curve"}), first);
  EXPECT_NE(drawn({"--font-size", "14 pt"}), first);
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
  EXPECT_EQ(drawn({"--component", "yy", "--range", "auto"}), first);
  EXPECT_NE(drawn({"--font-size", "14"}), first);
  std::set<std::string> all{first};
  for (const char* component : {"xx", "xy", "first", "third", "mises"})
    EXPECT_TRUE(all.insert(drawn({"--component", component})).second) << component;
  EXPECT_TRUE(all.insert(drawn({"--range", "-5:5 MPa"})).second);
  EXPECT_TRUE(all.insert(drawn({"--at", "10e-6"})).second);
  EXPECT_THAT(out_.str() + err_.str(), HasSubstr("p_000002.hdf, at 10.1 microstrain"));
}

TEST_F(PlotCommand, KnowsSharesOfAPeakOnlyWhereThereIsOne) {
  EXPECT_EQ(call({"plot", "run", "--at", "90%peak"}), Exit::data);
  EXPECT_THAT(err_.str(),
              HasSubstr("--at: 90%peak; the run reached no peak: its stress had not fallen again"));
  ASSERT_EQ(call({"simulate", "scene.toml", "-o", "broken", "--stop-strain", "4e-4"}), Exit::ok)
      << err_.str();
  const auto drawn = [&](const std::string& at) {
    EXPECT_EQ(call({"plot", "broken", "--at", at, "-o", "one.png"}), Exit::ok) << err_.str();
    return content("one.png");
  };
  EXPECT_EQ(drawn("50 %peak"), drawn("0.5peak"));
  const std::string at_peak = drawn("100%peak");
  ASSERT_EQ(call({"plot", "broken", "-o", "one.png"}), Exit::ok);
  EXPECT_EQ(content("one.png"), at_peak);
}

/// Four bytes of a PNG, the first the most significant.
std::uint32_t number_at(const std::string& png, std::size_t place) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(png.at(place + i));
  return value;
}

TEST_F(PlotCommand, HasTheWidthThatItIsGivenInPrint) {
  for (const char* what : {"damage", "curve", "stress"}) {
    ASSERT_EQ(call({"plot", "run", "--what", what, "--width", "90 mm", "-o", "one.png"}), Exit::ok)
        << err_.str();
    const std::string png = content("one.png");
    EXPECT_EQ(number_at(png, 16), 2126U) << what << ": 90 mm at 600 per inch";
    EXPECT_EQ(png.substr(37, 4), "pHYs");
    EXPECT_EQ(number_at(png, 41), 23622U);
    EXPECT_EQ(number_at(png, 45), 23622U);
    ASSERT_EQ(call({"plot", "run", "--what", what, "--width", "90 mm", "-o", "one.pdf"}), Exit::ok)
        << err_.str();
    EXPECT_THAT(content("one.pdf"), HasSubstr("/MediaBox [ 0 0 255.118")) << what;
    ASSERT_EQ(call({"plot", "run", "--what", what, "--width", "90 mm", "-o", "one.svg"}), Exit::ok)
        << err_.str();
    EXPECT_THAT(content("one.svg"), HasSubstr("width=\"255.118")) << what;
  }
}

TEST_F(PlotCommand, LaysCurvesOfRunsAndTestsOverEachOther) {
  ASSERT_EQ(call({"simulate", "scene.toml", "-o", "two", "--seed", "2"}), Exit::ok) << err_.str();
  test::write_text("test.csv", "strain (%),stress (MPa)\n0,0\n0.001,0.3\n0.002,0.5\n");
  const auto drawn = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"plot", "run", "--what", "curve", "-o", "one.png"});
    EXPECT_EQ(call(options), Exit::ok) << err_.str();
    return content("one.png");
  };
  std::set<std::string> all{drawn({})};
  EXPECT_TRUE(all.insert(drawn({"two"})).second);
  EXPECT_TRUE(all.insert(drawn({"two", "--measured", "test.csv"})).second);
  EXPECT_TRUE(all.insert(drawn({"two", "--measured", "test.csv", "--legend", "fine, other,test"})).second);
  EXPECT_TRUE(all.insert(drawn({"two", "--measured", "test.csv", "--legend", "none"})).second);
  EXPECT_TRUE(all.insert(drawn({"--measured", "test.csv"})).second);
  EXPECT_EQ(all.size(), 6U);
}

TEST_F(PlotCommand, RefusesCurvesThatCannotBeLaidOverEachOther) {
  const auto refusal = [&](std::vector<std::string> options, Exit code) {
    options.insert(options.begin(), {"plot", "run"});
    EXPECT_EQ(call(options), code) << err_.str();
    return err_.str();
  };
  EXPECT_THAT(refusal({"other"}, Exit::usage), HasSubstr("RUN: 2 given; must be one for --what damage"));
  EXPECT_THAT(refusal({"run", "--what", "curve"}, Exit::usage), HasSubstr("must not be given twice"));
  EXPECT_THAT(refusal({"--measured", "test.csv"}, Exit::usage), HasSubstr("is for curve"));
  EXPECT_THAT(refusal({"--what", "curve", "--legend", "a"}, Exit::usage),
              HasSubstr("--legend: a; changes nothing of a single curve"));
  test::write_text("test.csv", "strain,stress_MPa\n0,0\n1e-5,0.3\n2e-5,0.5\n");
  EXPECT_THAT(refusal({"--what", "curve", "--measured", "test.csv", "--legend", "a,b,c"}, Exit::usage),
              HasSubstr("--legend: a,b,c; has 3 names for 2 curves"));
  EXPECT_THAT(refusal({"--width", "5 mm"}, Exit::usage), HasSubstr("--width: 5 mm"));
  EXPECT_THAT(refusal({"--font-size", "99 pt"}, Exit::usage), HasSubstr("--font-size: 99"));
  EXPECT_THAT(refusal({"--width", "50 mm", "--font-size", "30 pt"}, Exit::usage),
              HasSubstr("--font-size: 30 pt; words of 30 pt do not fit; they must have 9.4 pt at most"));
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
