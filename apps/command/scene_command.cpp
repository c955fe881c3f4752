#include "apps/command/scene_command.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/command/command.hpp"
#include "apps/drawing/drawing_files.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/scene/test_scenes.hpp"
#include "apps/settings/schema.hpp"
#include "apps/system/files.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene_footer =
    "A scene says all about a run in one file. From nothing to a broken specimen:\n"
    "  mesopix scene init\n"
    "  mesopix simulate scene.toml\n"
    "Example: what is wrong with a scene, all of it\n"
    "  mesopix scene check scene.toml";

constexpr const char* footer_of_init =
    "The scene can be solved as it is, in seconds. Settings that a first run is about are given, all others "
    "that "
    "have an\neffect stand beside them as comments, with their defaults and what is allowed.\n"
    "Example: a notched beam in three-point bending, which breaks within a minute\n"
    "  mesopix scene init beam.toml --test three-point-bending\n"
    "Example: a scene for a photograph of a cut of 40 mm, and a schema with which an editor completes and "
    "checks "
    "keys\n"
    "  mesopix scene init cut.toml --picture cut.jpg --width \"40 mm\" --schema mesopix.schema.json";

constexpr const char* footer_of_check =
    "Makes the specimen and plans the run, but solves nothing. Mistakes are told in lines FILE:LINE:COLUMN: "
    "KEY: "
    "VALUE;\nALLOWED; CURE on standard output, or as a list with --json for editors. What only follows from "
    "other "
    "mistakes\nis left out. Exit codes: 0 nothing is wrong, 65 something is, 74 a file cannot be read. "
    "Studies are "
    "looked through\nwith their scene and all members.\n"
    "Example:\n"
    "  mesopix scene check scene.toml";

constexpr const char* footer_of_schema =
    "In draft 7, for the TOML plug-ins of editors (Taplo, Even Better TOML); a scene names its schema in the "
    "first "
    "line:\n"
    "  #:schema ./mesopix.schema.json\n"
    "which mesopix scene init --schema FILE writes. What depends on other keys only mesopix scene check "
    "tells.\n"
    "Example:\n"
    "  mesopix scene schema > mesopix.schema.json";

std::string schema_text() { return json_text(scene_schema()); }

mpm::Direction direction_named(const std::string& word) {
  Settings settings;
  try {
    if (!word.empty()) find_field("loading.direction")->set(settings, {word});
  } catch (const Mistake& mistake) {
    throw Rejected(Exit::usage, "--loading", word, mistake.allowed, mistake.cure);
  }
  return settings.scene.loading.direction;
}

std::vector<std::string> test_names() {
  std::vector<std::string> names;
  for (const TestScene& test : test_scenes()) names.push_back(test.name);
  return names;
}

class SceneInitCommand : public Command {
 public:
  explicit SceneInitCommand(CLI::App& scene)
      : Command(scene, "init", "Write a scene to begin with", footer_of_init) {
    option("[FILE]", argument_, "to write [scene.toml]", file_form({"toml"}));
    option("-o,--output", output_, "the same as FILE", file_form({"toml"}));
    flag("--overwrite", overwrite_, "replace a file that is there already");
    option("--picture", picture_, "the specimen is made from this picture", file_form(picture_endings()));
    option("--width", width_, "of the picture; by default as its file says",
           QuantityCodec{Dimension::length}.form());
    option("--specimen", specimen_, "the specimen is this file, specimen.h5", file_form({"h5"}));
    option("--loading", loading_, "what is done to it [tension]", find_field("loading.direction")->form);
    option("--test", test_, "a test of the laboratory, ready to run, in place of the others",
           one_of(test_names()));
    option("--schema", schema_, "write the JSON Schema into this file, and its name into the scene",
           file_form());
    flag("-q,--quiet", quiet_, "say nothing but errors");
  }

  Exit run(Console& console) override {
    const mpm::Direction direction = direction_named(loading_);
    check_options();
    for (const std::string& input : {picture_, specimen_})
      if (!input.empty()) (void)kind_of_input(input);
    const std::string text = scene_draft({picture_, width_, specimen_, direction, test_, file(), schema_});
    write_schema();
    mpm::replace_file(file(), text);
    console.say("wrote " + file());
    const CheckedFile checked = check_file(file());
    for (const Complaint& one : checked.complaints) console.say("to do: " + app::text(one));
    if (checked.complaints.empty()) console.say("next: mesopix simulate " + shell_word(file()));
    return Exit::ok;
  }

 private:
  void check_options() const {
    const auto refuse = [](const char* option, const char* other) {
      throw Rejected(Exit::usage, option, std::string("given with ") + other, "", "give one of the two");
    };
    if (!argument_.empty() && !output_.empty()) refuse("--output", "FILE");
    if (!picture_.empty() && !specimen_.empty()) refuse("--specimen", "--picture");
    for (const auto& [option, value] :
         {std::pair{"--picture", &picture_}, std::pair{"--specimen", &specimen_},
          std::pair{"--loading", &loading_}, std::pair{"--width", &width_}})
      if (!test_.empty() && !value->empty()) refuse(option, "--test");
    if (!test_.empty()) (void)test_scene_named(test_);
    if (!width_.empty() && picture_.empty())
      throw Rejected(Exit::usage, "--width", width_, "is that of a picture, and none is given",
                     "add --picture, or change generate.width in the scene");
    if (fs::path(file()).extension() != ".toml")
      throw Rejected(Exit::usage, "FILE", file(), "must end in .toml");
    if (fs::exists(file()) && !overwrite_)
      throw Rejected(Exit::usage, "FILE", file() + " is there already", "",
                     "choose another name, or give --overwrite");
  }

  [[nodiscard]] std::string file() const {
    return !argument_.empty() ? argument_ : !output_.empty() ? output_ : "scene.toml";
  }

  /// The same schema may be there already, beside other scenes.
  void write_schema() const {
    if (schema_.empty()) return;
    const std::string text = schema_text();
    if (fs::exists(schema_) && !overwrite_ && read_text_file(schema_) != text)
      throw Rejected(Exit::usage, "--schema", schema_ + " is there already, and another one", "",
                     "choose another name, or give --overwrite");
    mpm::replace_file(schema_, text);
  }

  std::string argument_;
  std::string picture_;
  std::string width_;
  std::string specimen_;
  std::string loading_;
  std::string test_;
  std::string schema_;
};

class SceneCheckCommand : public Command {
 public:
  explicit SceneCheckCommand(CLI::App& scene)
      : Command(scene, "check", "Tell all that is wrong with scenes and studies", footer_of_check) {
    option("FILE...", files_, "scene.toml, or study.toml", file_form({"toml"}));
    flag("--json", json_, "mistakes as a list in JSON");
    option("--picture", picture_,
           "draw the specimen with its supports, loads and gauges, where nothing is wrong",
           file_form({"svg", "png", "pdf"}));
    flag("-q,--quiet", quiet_, "say nothing of files in which nothing is wrong");
  }

  Exit run(Console& console) override {
    require(files_.empty() ? "" : files_.front(), "FILE", "mesopix scene check FILE");
    const std::string ending = fs::path(picture_).extension().string();
    if (!picture_.empty() && ending != ".svg" && ending != ".png" && ending != ".pdf")
      throw Rejected(Exit::usage, "--picture", picture_, "must end in .svg, .png or .pdf");
    if (!picture_.empty() && files_.size() > 1)
      throw Rejected(Exit::usage, "--picture", picture_, "is of one scene", "give one FILE");
    std::vector<CheckedFile> checked;
    for (const std::string& file : files_) checked.push_back(check_file(file));
    if (json_) console.out << json_text(complaints_json(checked));
    Exit code = Exit::ok;
    for (const CheckedFile& one : checked) {
      for (const Complaint& complaint : one.complaints)
        if (!json_) console.out << app::text(complaint) << '\n';
      for (const std::string& note : one.notes) console.say(one.file + ": note: " + note);
      if (one.complaints.empty() && !json_ && !quiet_)
        console.out << printable(one.file + ": " + one.what) << '\n';
      if (!one.readable) code = Exit::io;
      if (!picture_.empty() && one.complaints.empty()) draw(one, console);
      if (!one.complaints.empty() && code == Exit::ok) code = Exit::data;
    }
    return code;
  }

 private:
  void draw(const CheckedFile& checked, Console& console) const {
    if (!checked.set_up)
      throw Rejected(Exit::usage, "--picture", picture_, "needs a scene", "give one scene and no study");
    const std::string ending = fs::path(picture_).extension().string();
    mpm::replace_file(picture_,
                      ending == ".png"
                          ? output::png_of(*checked.set_up, 2)
                          : output::vector_file(
                                *checked.set_up,
                                ending == ".pdf" ? output::VectorFormat::pdf : output::VectorFormat::svg, 0));
    console.say("wrote " + picture_);
  }

  std::string picture_;
  std::vector<std::string> files_;
};

class SceneSchemaCommand : public Command {
 public:
  explicit SceneSchemaCommand(CLI::App& scene)
      : Command(scene, "schema", "Print the JSON Schema of scenes, for editors", footer_of_schema) {}

  Exit run(Console& console) override {
    console.out << schema_text();
    return Exit::ok;
  }
};

class SceneCommand : public Command {
 public:
  explicit SceneCommand(CLI::App& program)
      : Command(program, "scene", "Begin a scene, look through it, describe it to editors", scene_footer) {
    below_.push_back(std::make_unique<SceneInitCommand>(options()));
    below_.push_back(std::make_unique<SceneCheckCommand>(options()));
    below_.push_back(std::make_unique<SceneSchemaCommand>(options()));
  }

  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override {
    const std::string word = arguments.empty() ? "" : arguments.front();
    const std::vector<std::string> known = names();
    if (word.rfind('-', 0) != 0 && std::find(known.begin(), known.end(), word) == known.end())
      throw Rejected(Exit::usage, "mesopix scene", word.empty() ? "needs a command" : word,
                     "must be " + listed(known),
                     word.empty() ? "mesopix scene --help" : did_you_mean(word, known));
    return arguments;
  }

  Exit run(Console& /*console*/) override {
    throw Rejected(Exit::usage, "mesopix scene", "needs a command", "must be " + listed(names()),
                   "mesopix scene --help");
  }

 private:
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& command : below_) names.push_back(command->options().get_name());
    return names;
  }
};

}  // namespace

CommandPointer scene_command(CLI::App& parent) { return std::make_unique<SceneCommand>(parent); }

}  // namespace app
