#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/command/export_formats.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
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
    "failure_strain.tif).\n"
    "Example: a mesh of one element a pixel, with an element set a phase\n"
    "  mesopix export specimen.h5 --to inp";

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

exchange::PlaneElement plane_of(const std::string& name, const ExportFormat& format) {
  if (name.empty()) return exchange::PlaneElement::stress;
  if (!format.has_plane_elements)
    throw Rejected(Exit::usage, "--plane", std::string("given with --to ") + format.name,
                   "belongs to --to inp");
  if (name != "stress" && name != "strain")
    throw Rejected(Exit::usage, "--plane", name, "must be stress or strain",
                   did_you_mean(name, {"stress", "strain"}));
  return name == "stress" ? exchange::PlaneElement::stress : exchange::PlaneElement::strain;
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
    option("--plane", plane_, "inp: elements of plane stress (CPS4) or plane strain (CPE4) [stress]",
           one_of({"stress", "strain"}));
    json_and_quiet("the files and their format as JSON on standard output");
  }

  Exit run(Console& console) override {
    require(input_, "INPUT", "mesopix export INPUT --to inp");
    const ExportFormat& format = format_named(format_);
    const exchange::PlaneElement plane = plane_of(plane_, format);
    if (const std::string result_file = result_in(input_); !result_file.empty())
      return export_run(result_file, console);
    const std::optional<specimen::Specimen> specimen = specimen_in(input_);
    if (!specimen) return export_run(input_, console);
    const std::string output = output_.empty() ? default_output(input_, format) : output_;
    check_output_file(output, input_, format);
    console.say(format.write({*specimen, output, plane}));
    tell({output}, console);
    return Exit::ok;
  }

 private:
  void tell(const std::vector<std::string>& files, Console& console) const {
    if (json_) console.out << json_text({{"format", format_}, {"files", files}});
    for (const std::string& file : files) console.say("wrote " + file);
  }

  Exit export_run(const std::string& result_file, Console& console) const {
    if (format_ != "tif")
      throw Rejected(Exit::usage, input_, "is a run", "--to " + format_ + " needs a specimen",
                     "give the specimen, or --to tif for the damage of the run");
    const mpm::Result result = read_result(result_file);
    const double pixel_size = pixel_size_beside(result_file);
    const fs::path folder = folder_of_maps(output_, result_file);
    tell(write_run_maps(folder, {result, pixel_size}), console);
    return Exit::ok;
  }

  std::string input_;
  std::string format_;
  std::string plane_;
};

}  // namespace

CommandPointer export_command(CLI::App& parent) { return std::make_unique<ExportCommand>(parent); }

}  // namespace app
