#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/command/export_formats.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/settings/settings.hpp"
#include "apps/system/files.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* export_footer =
    "Formats of a specimen: inp (Abaqus, CalculiX), msh (Gmsh), vti (ParaView), png and tif (labels), csv\n"
    "(inclusions), roi (their outlines for ImageJ and Fiji). Of a run: tif (damage.tif and "
    "failure_strain.tif)\n"
    "and inp. An inp has one element a pixel, an element set a phase, elastic materials (of a run its own, "
    "else the "
    "defaults of\na scene), and a static step that moves the top edge; --mesh-only leaves the last two out.\n"
    "Example: the elastic test of a run for CalculiX\n"
    "  mesopix export runs/specimen --to inp -o test.inp";

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const ExportFormat& format : export_formats()) names.emplace_back(format.name);
  return names;
}

const ExportFormat& format_named(const std::string& name) {
  const std::vector<std::string> names = format_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Rejected(Exit::usage, "--to", name.empty() ? "missing" : name, "must be " + listed(names),
                   did_you_mean(name, names));
  return export_formats()[static_cast<std::size_t>(found - names.begin())];
}

/// @param usual  plane, of a run.
exchange::PlaneElement plane_of(const std::string& name, mpm::Plane usual) {
  if (name.empty())
    return usual == mpm::Plane::strain ? exchange::PlaneElement::strain : exchange::PlaneElement::stress;
  if (name != "stress" && name != "strain")
    throw Rejected(Exit::usage, "--plane", name, "must be stress or strain",
                   did_you_mean(name, {"stress", "strain"}));
  return name == "stress" ? exchange::PlaneElement::stress : exchange::PlaneElement::strain;
}

exchange::ElasticTest test_of(const mpm::Scene& scene) {
  exchange::ElasticTest test;
  for (const std::optional<mpm::Phase>& phase : scene.phases) {
    test.materials.emplace_back();
    if (phase) test.materials.back() = {phase->young, phase->poisson, phase->density};
  }
  if (scene.loading.direction == mpm::Direction::compression) test.strain = -test.strain;
  test.rough = scene.loading.platen == mpm::Platen::rough;
  return test;
}

/// With the materials that phases have where a scene sets none.
exchange::ElasticTest usual_test(const specimen::Specimen& specimen) {
  exchange::ElasticTest test;
  const std::vector<mpm::Phase> usual = Settings().phases;
  for (const std::string& name : specimen.mask.phases) {
    test.materials.emplace_back();
    for (const mpm::Phase& phase : usual)
      if (phase.name == name) test.materials.back() = {phase.young, phase.poisson, phase.density};
  }
  return test;
}

/// The specimen in a file, or nothing where the file holds a result.
std::optional<specimen::Specimen> specimen_in(const std::string& path) {
  try {
    return read_specimen(path);
  } catch (const specimen::Error& no_specimen) {
    try {
      (void)read_scene_text(path);
    } catch (const mpm::Error& no_result) {
      throw Rejected(Exit::data, path, "neither a specimen nor a result", no_specimen.what(),
                     no_result.what());
    }
  }
  return std::nullopt;
}

/// @return the result file that the input stands for; empty when it is no folder.
std::string result_in(const std::string& input) {
  switch (kind_of_input(input)) {
    case InputKind::folder:
      check_one_run(input);
      return (fs::path(input) / "result.h5").string();
    case InputKind::hdf5:
      return {};
    case InputKind::picture:
      throw Rejected(Exit::usage, input, "is no specimen", "must be a specimen or the folder of a run",
                     "mesopix convert turns a picture into a specimen");
    case InputKind::scene:
      throw Rejected(Exit::usage, input, "is a scene", "must be a specimen or the folder of a run",
                     "mesopix simulate runs it");
  }
  return {};
}

/// Beside the input, under its name.
std::string default_output(const fs::path& input, const ExportFormat& format) {
  return (input.parent_path() / (input.stem().string() + format.ending)).string();
}

/// A file that says by its name what it is, and is not the input.
void check_output_file(const std::string& output, const std::string& input, const ExportFormat& format) {
  const std::string ending = fs::path(format.ending).extension().empty()
                                 ? format.ending
                                 : fs::path(format.ending).extension().string();
  if (fs::path(output).extension() != ending)
    throw Rejected(Exit::usage, "-o", output, "must end in " + ending + " with --to " + format.name);
  std::error_code error;
  if (fs::equivalent(output, input, error) && !error)
    throw Rejected(Exit::usage, "-o", output, "would overwrite " + input, "choose another name");
}

/// Of the summary that lies beside the result of a run.
double pixel_size_beside(const std::string& result_file) {
  const std::string path = (fs::path(result_file).parent_path() / "summary.json").string();
  const auto summary = nlohmann::json::parse(read_text_file(path), nullptr, false);
  const nlohmann::json::json_pointer place("/specimen/pixel_size_m");
  const bool there = summary.is_object() && summary.contains(place) && summary[place].is_number();
  const double size = there ? summary[place].get<double>() : 0;
  if (!(size > 0))
    throw Rejected(Exit::data, path, "has no specimen.pixel_size_m", "must be the summary of the run");
  return size;
}

/// The folder for the maps of a run: the wanted one, made where it is missing, or that of the run itself.
fs::path folder_of_maps(const fs::path& wanted, const std::string& result_file) {
  if (wanted.empty()) return fs::path(result_file).parent_path();
  if (wanted.extension() == ".tif")
    throw Rejected(Exit::usage, "-o", wanted.string(),
                   "must be a folder, for damage.tif and failure_strain.tif");
  std::error_code error;
  fs::create_directories(wanted, error);
  if (error)
    throw Rejected(Exit::io, "-o", wanted.string(), "must be a folder that can be made", error.message());
  return wanted;
}

class ExportCommand : public Command {
 public:
  explicit ExportCommand(CLI::App& program)
      : Command(program, "export", "Write a specimen or a run in the format of another program",
                export_footer) {
    option("INPUT", input_, "specimen.h5, or folder of a run", file_form({"h5"}));
    option("--to", format_, "format", one_of(format_names()));
    option("-o,--output", output_, "file, or folder where INPUT is a run [beside INPUT, under its name]",
           file_form());
    option("--plane", plane_,
           "inp: elements of plane stress (CPS4) or plane strain (CPE4) [of a run its own, else stress]",
           one_of({"stress", "strain"}));
    flag("--mesh-only", mesh_only_, "inp: no materials, and no step");
    json_and_quiet("the files and their format as JSON on standard output");
  }

  Exit run(Console& console) override {
    require(input_, "INPUT", "mesopix export INPUT --to inp");
    const ExportFormat& format = format_named(format_);
    check_mesh_options(format);
    const std::string result_file = result_in(input_);
    if (!result_file.empty() && format.is_mesh) return export_test(format, console);
    if (!result_file.empty()) return export_run(result_file, console);
    const std::optional<specimen::Specimen> specimen = specimen_in(input_);
    if (!specimen) return export_run(input_, console);
    const std::string output = output_.empty() ? default_output(input_, format) : output_;
    check_output_file(output, input_, format);
    write(format,
          {*specimen, output, plane_of(plane_, mpm::Plane::stress), usual_test(*specimen),
           "a scene that sets none"},
          console);
    return Exit::ok;
  }

 private:
  void check_mesh_options(const ExportFormat& format) const {
    if (format.is_mesh) return (void)plane_of(plane_, mpm::Plane::stress);
    const char* given = !plane_.empty() ? "--plane" : mesh_only_ ? "--mesh-only" : nullptr;
    if (given != nullptr)
      throw Rejected(Exit::usage, given, std::string("given with --to ") + format.name,
                     "belongs to --to inp");
  }

  void write(const ExportFormat& format, SpecimenExport wanted, Console& console) const {
    if (mesh_only_ || !format.is_mesh) wanted.test.reset();
    console.say(format.write(wanted));
    tell({wanted.path}, console);
  }

  /// The specimen of a run as it was loaded, elastic.
  Exit export_test(const ExportFormat& format, Console& console) const {
    const ReadRun run = read_run(input_);
    const std::string output = output_.empty() ? (fs::path(input_) / "specimen.inp").string() : output_;
    check_output_file(output, input_, format);
    write(format, {run.specimen, output, plane_of(plane_, run.scene.plane), test_of(run.scene), "the run"},
          console);
    return Exit::ok;
  }

  void tell(const std::vector<std::string>& files, Console& console) const {
    if (json_) console.out << json_text({{"format", format_}, {"files", files}});
    for (const std::string& file : files) console.say("wrote " + file);
  }

  Exit export_run(const std::string& result_file, Console& console) const {
    if (format_ != "tif")
      throw Rejected(Exit::usage, input_, "is a run", "--to " + format_ + " needs a specimen",
                     "give the specimen, --to tif for the damage of the run, or its folder for --to inp");
    const mpm::Result result = read_result(result_file);
    const double pixel_size = pixel_size_beside(result_file);
    const fs::path folder = folder_of_maps(output_, result_file);
    tell(write_run_maps(folder, {result, pixel_size}), console);
    return Exit::ok;
  }

  std::string input_;
  std::string format_;
  std::string plane_;
  bool mesh_only_ = false;
};

}  // namespace

CommandPointer export_command(CLI::App& parent) { return std::make_unique<ExportCommand>(parent); }

}  // namespace app
