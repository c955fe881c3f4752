#include "apps/run/frame_folder.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/system/files.hpp"
#include "apps/text/figures.hpp"
#include "libmpm/files/frame_file.hpp"
#include "libmpm/files/replace_file.hpp"
#include "libmpm/scene/error.hpp"

namespace output {
namespace {

/// A dataset in the file of a frame. @param width  numbers a point. @param type  with its precision.
std::string data_item(const FrameEntry& frame, const std::string& dataset, int width,
                      const std::string& type) {
  return fmt::format(R"(<DataItem Dimensions="{} {}" {} Format="HDF">{}:/VTKHDF/{}</DataItem>)", frame.points,
                     width, type, frame.path, dataset);
}

const std::string float32 = R"(NumberType="Float" Precision="4")";
const std::string int64 = R"(NumberType="Int" Precision="8")";
const std::string int32 = R"(NumberType="Int" Precision="4")";
const std::string uint8 = R"(NumberType="UChar" Precision="1")";

struct Attribute {
  const char* name;
  const char* kind;
  int width;
  const std::string& type;
};
const std::array<Attribute, 6> attributes{{{"displacement", "Vector", 3, float32},
                                           {"velocity", "Vector", 3, float32},
                                           {"stress", "Tensor", 9, float32},
                                           {"damage", "Scalar", 1, float32},
                                           {"phase", "Scalar", 1, uint8},
                                           {"id", "Scalar", 1, int32}}};

}  // namespace

std::string frame_name(std::int64_t number) { return fmt::format("p_{:06}.hdf", number); }

bool is_frame_name(const std::string& name) {
  static const std::regex pattern("p_[0-9]{6,}[.]hdf");
  return std::regex_match(name, pattern);
}

void FrameSeries::add(const FrameEntry& frame) {
  if (!files_.empty()) files_ += ",\n";
  files_ += "    {\"name\": \"" + frame.path + "\", \"time\": " + exact(frame.time) + "}";
}

std::string FrameSeries::text() const {
  return "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n" + files_ + "\n  ]\n}\n";
}

void FrameXdmf::add(const FrameEntry& frame) {
  if (frame.points == 0) return;
  grids_ += fmt::format(
      R"(      <Grid Name="{}" GridType="Uniform">
        <Time Value="{}"/>
        <Topology TopologyType="Polyvertex" NumberOfElements="{}" NodesPerElement="1">{}</Topology>
        <Geometry GeometryType="XYZ">{}</Geometry>
)",
      frame.path, exact(frame.time), frame.points, data_item(frame, "Connectivity", 1, int64),
      data_item(frame, "Points", 3, float32));
  for (const Attribute& one : attributes)
    grids_ += fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n", one.name,
        one.kind, data_item(frame, std::string("PointData/") + one.name, one.width, one.type));
  grids_ += "      </Grid>\n";
}

std::string FrameXdmf::text() const {
  return "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
         "    <Grid Name=\"frames\" GridType=\"Collection\" CollectionType=\"Temporal\">\n" +
         grids_ + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

}  // namespace output

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* folder_name = "frames";
constexpr const char* series_name = "frames.hdf.series";
constexpr const char* xdmf_name = "frames.xdmf";

void remove_frame_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error)
    throw mpm::FileError(path.string(), "of an earlier run cannot be removed: " + error.message(), "",
                         "choose another folder");
}

/// Empty where there is no such file.
std::string text_of(const fs::path& path) {
  std::ostringstream text;
  app::require_regular_file(path.string());
  if (std::ifstream file(path, std::ios::binary); file) text << file.rdbuf();
  return text.str();
}

/// What is not a frame stays, and with it the folder.   @param kept  names of frames that stay.
void remove_frames(const fs::path& run, const std::set<std::string>& kept) {
  for (const fs::path& frame : frames_of(run))
    if (!kept.contains(frame.filename().string())) remove_frame_file(frame);
  std::error_code error;
  if (fs::is_directory(run / folder_name, error))
    fs::remove(run / folder_name, error);  // fails, as it should, while something is in it
}

}  // namespace

std::vector<fs::path> frames_of(const fs::path& run) {
  std::error_code error;
  std::vector<fs::path> frames;
  for (const fs::directory_entry& entry : fs::directory_iterator(run / folder_name, error))
    if (output::is_frame_name(entry.path().filename().string())) frames.push_back(entry.path());
  std::sort(frames.begin(), frames.end(), [](const fs::path& a, const fs::path& b) {
    const std::string left = a.filename().string(), right = b.filename().string();
    return left.size() != right.size() ? left.size() < right.size() : left < right;  // more digits come later
  });
  return frames;
}

FrameFolder::FrameFolder(fs::path run, const mpm::Scene& scene, const std::vector<mpm::FrameTaken>& taken,
                         std::string digest)
    : run_(std::move(run)), scene_(scene), digest_(std::move(digest)) {
  const std::set<std::string> kept = take_over(taken);
  remove_frames(run_, kept);
  if (!kept.empty()) {
    write_lists();
  } else {
    remove_frame_file(run_ / series_name);
    remove_frame_file(run_ / xdmf_name);
  }
}

/// What the list of the earlier part does not name is a frame that the disk did not take then.
std::set<std::string> FrameFolder::take_over(const std::vector<mpm::FrameTaken>& taken) {
  const std::string list = text_of(run_ / series_name);
  std::set<std::string> kept;
  for (const mpm::FrameTaken& frame : taken) {
    const std::string name = output::frame_name(added_);
    const fs::path path = run_ / folder_name / name;
    if (fs::exists(path)) {
      add_to_lists(added_, frame.time, frame.points);
      ++written_;
      kept.insert(name);
    } else if (list.find(name) != std::string::npos) {
      throw mpm::FileError(path.string(), "of the run that is to go on is missing", "",
                           "bring it back, or begin the run anew");
    } else if (!failure_) {
      failure_ = mpm::FileError(path.string(), "was not written before the run went on", "");
    }
    ++added_;
  }
  return kept;
}

bool FrameFolder::add(const mpm::Frame& frame) {
  try {
    write(frame, added_++);
    return true;
  } catch (const mpm::FileError& error) {
    if (!failure_) failure_ = error;
    return false;
  }
}

std::optional<mpm::FileError> FrameFolder::failure() const {
  if (!failure_ || written_ == added_) return failure_;
  return mpm::FileError(failure_->field, failure_->value, failure_->cure,
                        fmt::format("{} of {} frames are missing", added_ - written_, added_));
}

void FrameFolder::write(const mpm::Frame& frame, std::int64_t number) {
  const fs::path folder = run_ / folder_name;
  std::error_code error;
  fs::create_directory(folder, error);
  if (error)
    throw mpm::FileError(folder.string(), "cannot be created: " + error.message(), "",
                         "choose a folder that may be written to");
  mpm::write_frame((folder / output::frame_name(number)).string(), frame, scene_, digest_);
  ++written_;
  add_to_lists(number, frame.time, static_cast<std::int64_t>(frame.points.size()));
  write_lists();
}

void FrameFolder::add_to_lists(std::int64_t number, double time, std::int64_t points) {
  const output::FrameEntry entry{std::string(folder_name) + "/" + output::frame_name(number), time, points};
  list_.add(entry);
  xdmf_.add(entry);
}

void FrameFolder::write_lists() const {
  mpm::replace_file((run_ / series_name).string(), list_.text());
  mpm::replace_file((run_ / xdmf_name).string(), xdmf_.text());
}

fs::path FrameFolder::series() const { return run_ / series_name; }

}  // namespace app
