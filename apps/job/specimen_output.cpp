#include "apps/job/specimen_output.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/text/complaint.hpp"
#include "apps/text/json_text.hpp"
#include "apps/job/specimen_report.hpp"
#include "specimen/picture/picture.hpp"
#include "specimen/picture/preview.hpp"
#include "specimen/file/specimen_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

std::string ending(const std::string& path) {
  std::string text = fs::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string preview_path(const std::string& path) {
  const fs::path file(path);
  return (file.parent_path() / (file.stem().string() + "_preview.png")).string();
}

bool same_file(const std::string& first, const std::string& second) {
  std::error_code error;
  return fs::equivalent(first, second, error) && !error;
}

}  // namespace

void check_output(const std::string& path, const std::string& input) {
  constexpr std::array<const char*, 6> endings{".h5", ".png", ".tif", ".tiff", ".bmp", ".pgm"};
  if (std::find(endings.begin(), endings.end(), ending(path)) == endings.end())
    throw Rejected(Exit::usage, complaint("-o", path, "must end in .h5, .png, .tif, .tiff, .bmp or .pgm"));
  for (const std::string& file : {path, preview_path(path)})
    if (!input.empty() && same_file(file, input))
      throw Rejected(Exit::usage, complaint("-o", path, "would overwrite " + input, "choose another name"));
}

std::vector<std::string> write_specimen_output(const std::string& path, const specimen::Specimen& specimen) {
  if (ending(path) != ".h5") {
    specimen::write_labels(path, specimen.mask);
    return {path};
  }
  specimen::write_specimen(path, specimen);
  const std::string picture = preview_path(path);
  specimen::write_png(picture, specimen::preview(specimen.mask), specimen.mask.pixel_size);
  return {path, picture};
}

void report_specimen(Console& console, bool as_json, const Prepared& prepared, nlohmann::ordered_json figures,
                     const std::vector<std::string>& files) {
  for (const std::string& note : prepared.notes) console.say("note: " + note);
  if (as_json) {
    figures["notes"] = prepared.notes;
    figures["files"] = files;
    console.out << json_text(figures);
    return;
  }
  std::string text = specimen_text(figures);
  text.pop_back();  // its last line break: say() adds one
  console.say(text);
  for (const std::string& file : files) console.say("wrote " + file);
}

}  // namespace app
