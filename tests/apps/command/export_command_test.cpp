#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "libmpm/files/result_file.hpp"
#include "specimen/file/specimen_file.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/apps/program_in_folder.hpp"
#include "tests/apps/small_specimen.hpp"

namespace export_command_test {

namespace fs = std::filesystem;
using app::Exit;
using testing::EndsWith;
using testing::HasSubstr;

/// Exports from a folder of its own that holds specimen.h5, and a run of 2 x 3 pixels of 0.5 mm.
class ExportCommand : public test::ProgramInFolder {
 protected:
  ExportCommand() : ProgramInFolder("export") {}
  void SetUp() override {
    specimen::write_specimen("specimen.h5", test::small_specimen());
    mpm::Result result;
    result.failure_mode = mpm::PixelField<std::uint8_t>::Zero(2, 3);
    result.failure_strain = mpm::PixelField<float>::Constant(2, 3, std::numeric_limits<float>::quiet_NaN());
    result.failure_mode(0, 1) = 2;
    result.failure_strain(0, 1) = 1.5e-4F;
    write_run("run", result);
  }
  static void write_run(const fs::path& folder, const mpm::Result& result) {
    fs::create_directory(folder);
    mpm::write_result((folder / "result.h5").string(), result, "");
    test::write_text((folder / "summary.json").string(), R"({"specimen": {"pixel_size_m": 0.0005}})");
  }
};

TEST_F(ExportCommand, NamesTheFileAfterTheSpecimenBesideIt) {
  fs::create_directory("there");
  fs::copy_file("specimen.h5", "there/stone.h5");
  for (const auto& [format, file] : {std::pair{"inp", "stone.inp"},
                                     {"msh", "stone.msh"},
                                     {"vti", "stone.vti"},
                                     {"png", "stone_labels.png"},
                                     {"tif", "stone_labels.tif"},
                                     {"csv", "stone_inclusions.csv"}}) {
    EXPECT_EQ(run({"there/stone.h5", "--to", format}), Exit::ok) << err_.str();
    EXPECT_THAT(err_.str(), EndsWith(std::string("wrote there/") + file + "\n"));
    EXPECT_TRUE(fs::exists(fs::path("there") / file));
  }
}

TEST_F(ExportCommand, TellsItsFilesAsJsonAndIsQuiet) {
  ASSERT_EQ(run({"specimen.h5", "--to", "csv", "--json", "-q"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "");
  EXPECT_EQ(nlohmann::json::parse(out_.str()),
            (nlohmann::json{{"format", "csv"}, {"files", {"specimen_inclusions.csv"}}}));
  ASSERT_EQ(run({"run", "--to", "tif", "--json"}), Exit::ok) << err_.str();
  EXPECT_EQ(nlohmann::json::parse(out_.str())["files"].size(), 2u);
}

TEST_F(ExportCommand, TellsTheSetsOfAMesh) {
  EXPECT_EQ(run({"specimen.h5", "--to", "inp", "-o", "a.inp"}), Exit::ok);
  EXPECT_EQ(err_.str(),
            "144 elements and 169 nodes; element sets AGGREGATE and MORTAR, with the elastic materials of a "
            "scene that "
            "sets none; a static step moves the top edge by a strain of 0.0001\nwrote a.inp\n");
  EXPECT_EQ(run({"specimen.h5", "--to", "inp", "-o", "a.inp", "--mesh-only"}), Exit::ok);
  EXPECT_EQ(
      err_.str(),
      "144 elements and 169 nodes; element sets AGGREGATE and MORTAR; give them materials and sections\n"
      "wrote a.inp\n");
  EXPECT_THAT(test::read_text("a.inp"), HasSubstr("CPS4"));
  EXPECT_EQ(run({"specimen.h5", "--to", "inp", "-o", "a.inp", "--plane", "strain", "-q"}), Exit::ok);
  EXPECT_EQ(err_.str(), "");
  EXPECT_THAT(test::read_text("a.inp"), HasSubstr("CPE4"));
}

TEST_F(ExportCommand, LabelPicturesTellTheWayBack) {
  EXPECT_EQ(run({"specimen.h5", "--to", "png", "-o", "my labels.png"}), Exit::ok);
  EXPECT_EQ(
      err_.str(),
      "a specimen again: mesopix convert 'my labels.png' --label-phases 1:aggregate,2:mortar --itz-mode "
      "none\nwrote my labels.png\n");
  const specimen::Picture picture = specimen::read_picture("my labels.png");
  const specimen::LabelledMask mask = test::small_specimen().mask;
  EXPECT_TRUE(std::equal(mask.labels.data.begin(), mask.labels.data.end(), picture.gray.data.begin()));
  EXPECT_DOUBLE_EQ(picture.pixel_size, 1e-3);
}

TEST_F(ExportCommand, OutlinesTheInclusions) {
  specimen::Specimen specimen = test::small_specimen();
  specimen.inclusions.push_back(specimen::make_inclusion(1, {6e-3, 6e-3, 2e-3, 2e-3, 0}));
  specimen::write_specimen("round.h5", specimen);
  EXPECT_EQ(run({"round.h5", "--to", "roi"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "1 inclusion\nwrote round_rois.zip\n");
  expect_refusal({"specimen.h5", "--to", "roi"}, Exit::data,
                 "specimen: has no inclusions; there is nothing to outline");
}

TEST_F(ExportCommand, MapsOfARunLieInItsFolder) {
  for (const std::string input : {"run", "run/result.h5"}) {
    EXPECT_EQ(run({input, "--to", "tif"}), Exit::ok) << err_.str();
    EXPECT_EQ(err_.str(), "wrote run/damage.tif\nwrote run/failure_strain.tif\n");
  }
  const specimen::Picture damage = specimen::read_picture("run/damage.tif");
  EXPECT_EQ(damage.bits, 8);
  EXPECT_DOUBLE_EQ(damage.pixel_size, 0.5e-3);
  EXPECT_THAT(damage.gray.data.doubles(), testing::ElementsAre(0, 2, 0, 0, 0, 0));
}

TEST_F(ExportCommand, FailureStrainsAreThoseOfTheResult) {
  mpm::Result broken;
  broken.failure_mode = mpm::PixelField<std::uint8_t>::Ones(2, 2);
  broken.failure_strain.resize(2, 2);
  broken.failure_strain << 1e-4F, 2e-4F, 3e-4F, 4e-4F;
  write_run("broken", broken);
  EXPECT_EQ(run({"broken", "--to", "tif", "-q"}), Exit::ok) << err_.str();
  const specimen::Picture strain = specimen::read_picture("broken/failure_strain.tif");
  EXPECT_EQ(strain.bits, 32);
  EXPECT_DOUBLE_EQ(strain.pixel_size, 0.5e-3);
  EXPECT_THAT(strain.gray.data.doubles(), testing::ElementsAre(1e-4F, 2e-4F, 3e-4F, 4e-4F))
      << "the top row first";
}

TEST_F(ExportCommand, MapsOfARunGoWhereTheyAreWanted) {
  EXPECT_EQ(run({"run", "--to", "tif", "-o", "maps/of/run"}), Exit::ok) << err_.str();
  EXPECT_TRUE(fs::exists("maps/of/run/damage.tif"));
  EXPECT_TRUE(fs::exists("maps/of/run/failure_strain.tif"));
  expect_refusal({"run", "--to", "tif", "-o", "specimen.h5"}, Exit::io,
                 "-o: specimen.h5; must be a folder that can be made; Not a directory");
  expect_refusal({"run", "--to", "tif", "-o", "a.tif"}, Exit::usage,
                 "-o: a.tif; must be a folder, for damage.tif and failure_strain.tif");
}

TEST_F(ExportCommand, NeedsTheSummaryOfTheRunForItsScale) {
  test::write_text("run/summary.json", "{}");
  expect_refusal({"run", "--to", "tif"}, Exit::data,
                 "run/summary.json: has no specimen.pixel_size_m; must be the summary of the run");
  fs::remove("run/summary.json");
  expect_refusal({"run", "--to", "tif"}, Exit::io,
                 "run/summary.json: No such file or directory; must be a file that can be read");
}

TEST_F(ExportCommand, SaysWhichFormatsThereAre) {
  expect_refusal({"specimen.h5"}, Exit::usage, "--to: missing; must be inp, msh, vti, png, tif, csv or roi");
  expect_refusal({"specimen.h5", "--to", "imp"}, Exit::usage,
                 "--to: imp; must be inp, msh, vti, png, tif, csv or roi; did you mean inp?");
  expect_refusal({}, Exit::usage, "INPUT: missing; mesopix export INPUT --to inp");
}

TEST_F(ExportCommand, TellsASpecimenFromARun) {
  expect_refusal({"run/result.h5", "--to", "roi"}, Exit::usage,
                 "run/result.h5: is a run; --to roi needs a specimen; give the specimen, --to tif for the "
                 "damage of the run, or its folder for --to inp");
  test::write_text("scene.toml", "");
  expect_refusal(
      {"scene.toml", "--to", "inp"}, Exit::usage,
      "scene.toml: is a scene; must be a specimen or the folder of a run; mesopix simulate runs it");
  test::write_text("a.png", "");
  expect_refusal({"a.png", "--to", "inp"}, Exit::usage,
                 "a.png: is no specimen; must be a specimen or the folder of a run; mesopix convert turns a "
                 "picture into a specimen");
  test::write_text("empty.h5", "\x89HDF\r\n\x1a\n");
  EXPECT_EQ(run({"empty.h5", "--to", "inp"}), Exit::data);
  EXPECT_THAT(err_.str(), HasSubstr("empty.h5: neither a specimen nor a result; "));
  fs::create_directory("hollow");
  EXPECT_EQ(run({"hollow", "--to", "tif"}), Exit::io);
  EXPECT_THAT(err_.str(), HasSubstr("hollow/result.h5: "));
}

TEST_F(ExportCommand, GivesTheElasticTestOfARun) {
  specimen::write_specimen("stone.h5", test::small_specimen());
  ASSERT_EQ(call({"simulate", "stone.h5", "--direction", "compression", "--platen", "rough", "--stop-strain",
                  "1e-5", "--mortar.young", "25 GPa", "-o", "loaded"}),
            Exit::ok)
      << err_.str();
  EXPECT_EQ(run({"loaded", "--to", "inp"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(),
              HasSubstr("with the elastic materials of the run; a static step moves the top edge by a "
                        "strain of -0.0001\nwrote loaded/specimen.inp\n"));
  const std::string text = test::read_text("loaded/specimen.inp");
  EXPECT_THAT(text, HasSubstr("NAME=M_MORTAR\n*ELASTIC\n2.5e+10, 0.2\n"));
  EXPECT_THAT(text, HasSubstr("TOP, 1, 1\n"));
  EXPECT_THAT(text, HasSubstr("TYPE=CPE4"));
}

TEST_F(ExportCommand, RefusesOptionsOfOtherFormats) {
  expect_refusal({"specimen.h5", "--to", "msh", "--mesh-only"}, Exit::usage,
                 "--mesh-only: given with --to msh; belongs to --to inp");

  expect_refusal({"specimen.h5", "--to", "msh", "--plane", "strain"}, Exit::usage,
                 "--plane: given with --to msh; belongs to --to inp");
  expect_refusal({"specimen.h5", "--to", "inp", "--plane", "stran"}, Exit::usage,
                 "--plane: stran; must be stress or strain; did you mean strain?");
}

TEST_F(ExportCommand, WritesNoFileOfAnotherKindAndNotOverTheInput) {
  expect_refusal({"specimen.h5", "--to", "inp", "-o", "a.msh"}, Exit::usage,
                 "-o: a.msh; must end in .inp with --to inp");
  fs::create_symlink("specimen.h5", "link.vti");
  expect_refusal({"specimen.h5", "--to", "vti", "-o", "link.vti"}, Exit::usage,
                 "-o: link.vti; would overwrite specimen.h5; choose another name");
  expect_refusal({"specimen.h5", "--to", "vti", "-o", "none/a.vti"}, Exit::io,
                 "none/a.vti: could not be written: No such file or directory; create its folder first");
}

}  // namespace export_command_test
