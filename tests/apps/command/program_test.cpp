#include "apps/command/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "libmpm/files/frame_file.hpp"
#include "libmpm/files/table_file.hpp"
#include "specimen/file/specimen_file.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/apps/program_in_folder.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace program_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Runs the program in a folder of its own, without starting a process.
class Program : public test::ProgramInFolder {
 protected:
  /// A specimen of 20 mm with pixels of 1 mm, made in no time.
  void make_small_specimen(const std::string& file) {
    ASSERT_EQ(run({"generate", "--width", "20 mm", "--height", "20 mm", "--pixel-size", "1 mm", "--fraction",
                   "0.3", "--d-min", "4 mm", "--d-max", "8 mm", "-o", file}),
              Exit::ok)
        << err_.str();
  }
};

TEST_F(Program, TellsItsVersion) {
  EXPECT_EQ(run({"--version"}), Exit::ok);
  EXPECT_THAT(out_.str(), StartsWith("mesopix "));
}

TEST_F(Program, HelpNamesEveryCommandWithAnExample) {
  EXPECT_EQ(run({"--help"}), Exit::ok);
  for (const char* command : {"generate", "convert", "scene", "simulate", "calibrate", "stiffness", "inspect",
                              "report", "plot", "export", "doctor"})
    EXPECT_THAT(out_.str(), HasSubstr(command));
  EXPECT_LT(out_.str().find("generate"), out_.str().find("simulate"));
  EXPECT_LT(out_.str().find("simulate"), out_.str().find("inspect"));
  for (const std::string command : {"generate", "convert", "scene", "simulate", "calibrate", "stiffness",
                                    "inspect", "report", "plot", "export", "doctor"}) {
    EXPECT_EQ(run({command, "--help"}), Exit::ok);
    EXPECT_THAT(out_.str(), HasSubstr("Usage: mesopix " + command));
    EXPECT_THAT(out_.str(), HasSubstr("Example"));
    EXPECT_THAT(err_.str(), IsEmpty());
  }
}

TEST_F(Program, WithoutArgumentsHelpsAndFails) {
  EXPECT_EQ(run({}), Exit::usage);
  EXPECT_THAT(err_.str(), HasSubstr("Usage: mesopix"));
}

TEST_F(Program, RefusesWhatItDoesNotKnow) {
  expect_refusal(
      {"simulte"}, Exit::usage,
      "simulte: unknown command; must be generate, convert, twin, scene, simulate, study, calibrate, "
      "stiffness, inspect, report, plot, export, doctor or help; did you mean simulate?");
  expect_refusal(
      {"bench"}, Exit::usage,
      "bench: is not in this build; ./quickstart all builds it, or cmake with -DMESOPIX_EVIDENCE=ON");
  expect_refusal(
      {"--json"}, Exit::usage,
      "--json: is no command; must be generate, convert, twin, scene, simulate, study, calibrate, "
      "stiffness, inspect, report, plot, export, doctor or help; mesopix --help tells what they do");
  expect_refusal({"generate", "--widht", "3 mm"}, Exit::usage,
                 "--widht: unknown option; did you mean --width?; mesopix generate --help lists them");
  expect_refusal({"generate", "--width"}, Exit::usage,
                 "--width: needs a value; mesopix generate --help tells which");
  expect_refusal({"simulate"}, Exit::usage, "INPUT: missing; mesopix simulate INPUT");
  expect_refusal({"convert"}, Exit::usage, "PICTURE: missing; mesopix convert PICTURE");
  expect_refusal({"calibrate"}, Exit::usage, "SCENE: missing; mesopix calibrate SCENE");
  expect_refusal({"inspect"}, Exit::usage, "FILE: missing; mesopix inspect FILE");
}

TEST_F(Program, AFileMayBeCalledAsACommandIs) {
  expect_refusal({"inspect", "study"}, Exit::io,
                 "study: No such file or directory; must be a file that can be read");
}

TEST_F(Program, ColoursWhatATerminalShowsAndNothingElse) {
  const auto told = [](const std::vector<std::string>& arguments, bool coloured) {
    std::ostringstream out;
    std::ostringstream err;
    app::Console console{out, err, false, false, {}, coloured, coloured};
    (void)app::run_program(arguments, console);
    return out.str() + err.str();
  };
  const std::string red = "\x1b[1;31mmesopix:\x1b[0m simulte: unknown command";
  EXPECT_THAT(told({"simulte"}, true), StartsWith(red));
  EXPECT_THAT(told({"simulte"}, false), StartsWith("mesopix: simulte: unknown command"));
  for (const std::vector<std::string>& help :
       {std::vector<std::string>{"--help"}, {"help"}, {"simulate", "--help"}, {}}) {
    EXPECT_THAT(told(help, true), HasSubstr("\x1b[1mOptions:\x1b[0m\n"));
    EXPECT_THAT(told(help, false), testing::Not(HasSubstr("\x1b")));
  }
}

TEST_F(Program, RefusesValuesOfOptions) {
  expect_refusal({"generate", "--width", "75"}, Exit::usage,
                 "--width: 75; needs a unit; write e.g. \"0.5 mm\"");
  expect_refusal({"generate", "--fraction", "1.5"}, Exit::usage, "--fraction: 1.5; must lie in [0, 1)");
  expect_refusal(
      {"generate", "--grading", "fuler"}, Exit::usage,
      "--grading: fuler; must be fuller, A8, B8, C8, A16, B16, C16, A32, B32 or C32; did you mean fuller?");
}

TEST_F(Program, RefusesTextThatIsNotUtf8) {
  make_small_specimen("a.h5");
  expect_refusal({"simulate", "a.h5", "--title", "caf\xE9"}, Exit::usage,
                 "--title: caf?; must be text in UTF-8");
}

TEST_F(Program, LocatesWhatALibraryRefuses) {
  test::write_text("scene.toml", "[generate]\nwidth = \"60.3 mm\"\n");
  expect_refusal({"generate", "scene.toml"}, Exit::data,
                 "scene.toml:2:9: generate.width: 60.3 mm; must be a whole number of pixels of 0.5 mm; take "
                 "60 mm or 60.5 mm");
  expect_refusal({"generate", "--d-max", "3 mm"}, Exit::data,
                 "--d-max: 3 mm; must be above d_min, which is 5 mm; swap them or widen the range");
}

TEST_F(Program, RefusesInputsThatAreNotThere) {
  for (const std::string command : {"simulate", "convert", "inspect"})
    expect_refusal({command, "nothing.h5"}, Exit::io,
                   "nothing.h5: No such file or directory; must be a file that can be read");
  expect_refusal({"generate", "nothing.toml"}, Exit::io,
                 "nothing.toml: No such file or directory; must be a file that can be read");
}

TEST_F(Program, GenerateWritesASpecimenAndItsPicture) {
  make_small_specimen("a.h5");
  EXPECT_THAT(err_.str(), HasSubstr("wrote a.h5\nwrote a_preview.png\n"));
  EXPECT_THAT(err_.str(), HasSubstr("specimen 20 mm x 20 mm, 20 x 20 pixels of 1 mm"));
  EXPECT_THAT(out_.str(), IsEmpty());
  const specimen::Specimen specimen = specimen::read_specimen("a.h5");
  EXPECT_EQ(specimen.mask.labels.cols, 20);
  EXPECT_EQ(specimen.provenance.source, "generated");
  EXPECT_EQ(specimen.provenance.seed, 1u);
  EXPECT_THAT(specimen.provenance.options, HasSubstr("fraction = 0.3"));
  EXPECT_EQ(specimen::read_picture("a_preview.png").cols(), 20);
}

TEST_F(Program, GenerateIsRepeatable) {
  make_small_specimen("a.h5");
  make_small_specimen("b.h5");
  EXPECT_EQ(test::read_text("a.h5"), test::read_text("b.h5"));
}

TEST_F(Program, GenerateDrawsTheProvenanceAgain) {
  make_small_specimen("a.h5");
  test::write_text("again.toml", specimen::read_specimen("a.h5").provenance.options);
  ASSERT_EQ(run({"generate", "again.toml", "-o", "b.h5"}), Exit::ok) << err_.str();
  EXPECT_EQ(test::read_text("a.h5"), test::read_text("b.h5"));
}

TEST_F(Program, GenerateReportsAsJson) {
  ASSERT_EQ(run({"generate", "--width", "40 mm", "--height", "40 mm", "--d-max", "10 mm", "--json", "-q"}),
            Exit::ok);
  EXPECT_THAT(err_.str(), IsEmpty());
  const json figures = json::parse(out_.str());
  EXPECT_EQ(figures["files"], (json{"specimen.h5", "specimen_preview.png"}));
  EXPECT_NEAR(figures["aggregates"]["area_fraction"].get<double>(), 0.45, 0.01);
  EXPECT_EQ(figures["aggregates"]["sieve"].back()["passing"], 1);
  EXPECT_EQ(figures["columns"], 80);
  double sum = 0;
  for (const auto& phase : figures["phases"]) sum += phase["fraction"].get<double>();
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST_F(Program, GenerateDrawsAListOfEllipses) {
  test::write_text("list.csv", "x_mm,y_mm,a_mm,b_mm\n10,10,5,5\n");
  const std::vector<std::string> square{"--width", "20 mm", "--height", "20 mm", "-o", "a.png"};
  std::vector<std::string> arguments{"generate", "--ellipses", "list.csv"};
  arguments.insert(arguments.end(), square.begin(), square.end());
  ASSERT_EQ(run(arguments), Exit::ok) << err_.str();
  EXPECT_EQ(specimen::read_picture("a.png").gray(20, 20), specimen::phase::aggregate);
  EXPECT_EQ(specimen::read_picture("a.png").gray(0, 0), specimen::phase::mortar);
  arguments.insert(arguments.end(), {"--fraction", "0.4"});
  expect_refusal(arguments, Exit::usage, "--fraction: 0.4; has no effect on given ellipses; remove it");
}

TEST_F(Program, GenerateRefusesEndingsAndOtherSources) {
  expect_refusal({"generate", "-o", "a.jpg"}, Exit::usage,
                 "-o: a.jpg; must end in .h5, .png, .tif, .tiff, .bmp or .pgm");
  test::write_text("scene.toml", "[specimen]\npicture = \"a.png\"\n");
  expect_refusal({"generate", "scene.toml"}, Exit::data,
                 "scene.toml:2:11: specimen.picture: given; generate draws ellipses; use mesopix convert");
}

TEST_F(Program, InspectTellsWhatIsInASpecimenAndAPicture) {
  make_small_specimen("a.h5");
  EXPECT_EQ(run({"inspect", "a.h5"}), Exit::ok);
  EXPECT_THAT(out_.str(),
              StartsWith("specimen 20 mm x 20 mm, 20 x 20 pixels of 1 mm, generated with seed 1\n"));
  EXPECT_EQ(run({"inspect", "a_preview.png", "--json"}), Exit::ok);
  const json figures = json::parse(out_.str());
  EXPECT_EQ(figures["kind"], "picture");
  EXPECT_EQ(figures["columns"], 20);
  EXPECT_NEAR(figures["pixel_size_m"].get<double>(), 1e-3, 1e-6);
}

TEST_F(Program, InspectTellsWhatIsInAFrameAndATable) {
  mpm::Frame frame;
  frame.step = 7;
  frame.strain = 2e-4;
  mpm::write_frame("p.hdf", frame, samples::mortar_block(2, 2));
  EXPECT_EQ(run({"inspect", "p.hdf"}), Exit::ok) << err_.str();
  EXPECT_EQ(out_.str(), "frame of 0 points at strain 200e-6, after 7 steps\n");
  mpm::write_table("t.h5", {{"peak", "Pa", "largest stress", std::vector<double>{1, 2}}});
  EXPECT_EQ(run({"inspect", "t.h5"}), Exit::ok) << err_.str();
  EXPECT_EQ(out_.str(), "table of 2 rows and 1 columns\n  peak [Pa]: largest stress\n");
  std::string bytes = test::read_text("t.h5");
  bytes[bytes.size() / 2] ^= 1;
  test::write_text("t.h5", bytes);
  EXPECT_EQ(run({"inspect", "t.h5", "--json"}), Exit::data);
  EXPECT_THAT(err_.str(), HasSubstr("t.h5: is damaged: its digest does not match its bytes"));
}

TEST_F(Program, InspectRefusesScenesAndOtherFiles) {
  test::write_text("scene.toml", "");
  expect_refusal({"inspect", "scene.toml"}, Exit::usage,
                 "scene.toml: is a scene; must be a specimen, a result, a run folder, a frame, a table or a "
                 "picture; mesopix simulate "
                 "--print-scene scene.toml resolves it");
  test::write_text("note.txt", "words");
  EXPECT_EQ(run({"inspect", "note.txt"}), Exit::data);
  EXPECT_THAT(err_.str(), StartsWith("mesopix: note.txt: "));
}

TEST_F(Program, PrintSceneResolvesEverySettingOnce) {
  test::write_text("scene.toml", "[loading]\nvelocity = \"0.1 m/s\"\n");
  ASSERT_EQ(run({"simulate", "scene.toml", "--mortar.young", "25 GPa", "--print-scene"}), Exit::ok)
      << err_.str();
  const std::string resolved = out_.str();
  EXPECT_THAT(resolved, HasSubstr("velocity = \"0.1 m/s\""));
  EXPECT_THAT(resolved, HasSubstr("young = \"25 GPa\""));
  EXPECT_THAT(resolved, HasSubstr("title = \"scene\""));
  test::write_text("again.toml", resolved);
  ASSERT_EQ(run({"simulate", "again.toml", "--print-scene"}), Exit::ok) << err_.str();
  EXPECT_EQ(out_.str(), resolved);
  EXPECT_FALSE(fs::exists("runs"));
}

TEST_F(Program, ASpecimenThatChangedIsRefused) {
  make_small_specimen("a.h5");
  test::write_text("scene.toml", "[specimen]\nfile = \"a.h5\"\nsha256 = \"abc\"\n");
  EXPECT_EQ(run({"simulate", "scene.toml", "--print-scene"}), Exit::data);
  EXPECT_THAT(err_.str(), StartsWith("mesopix: scene.toml:3:10: specimen.sha256: a.h5 has "));
}

TEST_F(Program, SimulateWritesAFolderAndSaysWhatCameOut) {
  make_small_specimen("a.h5");
  ASSERT_EQ(run({"simulate", "a.h5"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), testing::MatchesRegex("peak .* MPa at strain .*\nwrote runs/a\n"));
  EXPECT_TRUE(fs::exists("runs/a/result.h5"));
  EXPECT_EQ(run({"inspect", "runs/a", "--json"}), Exit::ok);
  EXPECT_EQ(json::parse(out_.str())["points"], 400);
}

TEST_F(Program, SimulateReportsAsJson) {
  make_small_specimen("a.h5");
  ASSERT_EQ(run({"simulate", "a.h5", "--json", "-q", "--direction", "compression"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), IsEmpty());
  const json figures = json::parse(out_.str());
  EXPECT_EQ(figures["direction"], "compression");
  EXPECT_GT(figures["peak_stress_Pa"].get<double>(), 0);
}

TEST_F(Program, SimulateCropsToWholeCellsAndKeepsTheNote) {
  ASSERT_EQ(run({"generate", "--width", "21 mm", "--height", "20 mm", "--pixel-size", "1 mm", "--fraction",
                 "0.2", "--d-min", "4 mm", "--d-max", "8 mm", "-o", "a.h5"}),
            Exit::ok);
  ASSERT_EQ(run({"simulate", "a.h5", "--cell", "2 x 2", "--json"}), Exit::ok) << err_.str();
  const std::string note =
      "the specimen was cropped from 21 x 20 to 20 x 20 pixels, at its top and right edges, to whole cells "
      "of 2 x 2 "
      "pixels";
  EXPECT_THAT(err_.str(), HasSubstr("note: " + note + "\n"));
  EXPECT_EQ(json::parse(out_.str())["notes"], json{note});
}

TEST_F(Program, SimulateKeepsWhatWasComputedBeforeItDiverged) {
  // Pixels alone in their cells beside a block of mortar bear no such step.
  std::string picture = "P2\n12 12\n2\n";
  for (int row = 0; row < 12; ++row)
    picture += row % 4 == 2 ? "2 2 2 2 2 2 0 2 0 0 0 0\n" : "2 2 2 2 2 2 0 0 0 0 0 0\n";
  test::write_text("a.pgm", picture);
  EXPECT_EQ(run({"simulate",
                 "a.pgm",
                 "--convert.method",
                 "labels",
                 "--convert.label-phases",
                 "0:void,2:mortar",
                 "--convert.pixel-size",
                 "1 mm",
                 "--cfl",
                 "1",
                 "--mortar.poisson",
                 "0.4999",
                 "--mortar.tensile-scale",
                 "unbreakable",
                 "--cell",
                 "2 x 2",
                 "--local-damping",
                 "0",
                 "-o",
                 "b"}),
            Exit::data);
  EXPECT_THAT(err_.str(), HasSubstr("mesopix: simulate: "));
  EXPECT_THAT(err_.str(), HasSubstr("; what was computed is in b\n"));
  EXPECT_TRUE(fs::exists("b/curve.csv"));
}

TEST_F(Program, SimulateLeavesNoFolderWhereItCouldNotBegin) {
  make_small_specimen("a.h5");
  EXPECT_EQ(run({"simulate", "a.h5", "--mortar.poisson", "0.5"}), Exit::data);
  EXPECT_THAT(err_.str(), HasSubstr("--mortar.poisson: 0.5; must lie in [0, 0.4999] in plane strain"));
  EXPECT_FALSE(fs::exists("runs"));
}

TEST_F(Program, AMisspeltPhaseIsLocated) {
  make_small_specimen("a.h5");
  test::write_text("scene.toml", "[specimen]\nfile = \"a.h5\"\n[phases.mortr]\nyoung = \"20 GPa\"\n");
  expect_refusal(
      {"simulate", "scene.toml"}, Exit::data,
      "scene.toml:4:9: phases.mortr: no such phase; the specimen has void, aggregate, mortar and itz; did "
      "you mean mortar?");
}

TEST_F(Program, OverlappingEllipsesAreLocatedInTheirFile) {
  test::write_text("list.csv", "x_mm,y_mm,a_mm,b_mm\n30,30,5,5\n34,30,5,5\n");
  EXPECT_EQ(run({"generate", "--ellipses", "list.csv"}), Exit::data);
  EXPECT_THAT(err_.str(), StartsWith("mesopix: list.csv: ellipses: number 1 at (30, 30) mm and number 2"));
}

TEST_F(Program, ConvertReadsItsOwnLabelsBack) {
  ASSERT_EQ(run({"generate", "--width", "60 mm", "--height", "60 mm", "-o", "a.png"}), Exit::ok);
  ASSERT_EQ(run({"convert", "a.png", "-o", "b.png", "--reference", "a.png", "--json"}), Exit::ok)
      << err_.str();
  EXPECT_EQ(specimen::read_picture("a.png").gray, specimen::read_picture("b.png").gray);
  const json report = json::parse(out_.str());
  EXPECT_FALSE(report["intersection_over_union"].empty());
  for (const auto& share : report["intersection_over_union"]) EXPECT_EQ(share, 1);
}

TEST_F(Program, ConvertNeverOverwritesItsPicture) {
  ASSERT_EQ(run({"generate", "--width", "60 mm", "--height", "60 mm", "-o", "a.h5"}), Exit::ok);
  expect_refusal({"convert", "a_preview.png", "-o", "a_preview.png"}, Exit::usage,
                 "-o: a_preview.png; would overwrite a_preview.png; choose another name");
  expect_refusal({"convert", "a_preview.png", "-o", "a.h5"}, Exit::usage,
                 "-o: a.h5; would overwrite a_preview.png; choose another name");
}

}  // namespace program_test
