#include "specimen/teach/model_file.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

#include "specimen/body/error.hpp"
#include "specimen/body/files.hpp"
#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

constexpr const char* first_line = "mesopix model";
constexpr int model_version = 1;
/// Changes whenever a feature is computed in another way, so that no forest meets features that it does not
/// know.
constexpr const char* feature_set = "pyramid 1";
constexpr std::size_t digest_length = 64;
constexpr std::int64_t largest_file = 256 << 20;  ///< [byte]
constexpr const char* teach_anew =
    "teach it anew from the strokes: mesopix convert PICTURE --strokes STROKES --save-model MODEL";

class ByteWriter {
 public:
  void number(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255U);
  }
  void number(float value) { number(std::bit_cast<std::uint32_t>(value)); }
  std::string bytes;
};

class ByteReader {
 public:
  ByteReader(const std::string& bytes, std::size_t begin, std::size_t end)
      : bytes_(bytes), at_(begin), end_(end) {}
  std::uint32_t number() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at_++])) << shift;
    return value;
  }
  float real() { return std::bit_cast<float>(number()); }
  [[nodiscard]] bool holds(std::uint64_t numbers) const { return numbers <= (end_ - at_) / 4; }
  [[nodiscard]] bool is_at_end() const { return at_ == end_; }

 private:
  const std::string& bytes_;
  std::size_t at_, end_;
};

std::string words_of(const TaughtModel& model) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << first_line << "\nversion = " << model_version << "\nfeatures = " << feature_set
       << "\nscales = " << model.scales << "\naveraged = " << model.factor
       << "\npixel_size_m = " << model.pixel_size << "\nevens_light = " << (model.evens_light ? 1 : 0)
       << "\ntrees = " << model.forest.roots.size() << '\n';
  for (const std::string& phase : model.phases) text << "phase = " << phase << '\n';
  text << '\n';
  return text.str();
}

Error damaged(const std::string& path, const std::string& how) {
  return {path, "is damaged: " + how, "a model is read as it was written", teach_anew};
}

/// The lines before the empty one.
struct Heading {
  int version = 0, trees = 0;
  std::string features;
  TaughtModel model;
  std::size_t length = 0;  ///< [byte], with the empty line
};

double number_of(const std::string& text, double low, double high, const std::string& path,
                 const std::string& key) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = std::numeric_limits<double>::quiet_NaN();
  stream >> value;
  if (!stream || !(value >= low && value <= high)) throw damaged(path, key + " = " + text);
  return value;
}

Heading heading_of(const std::string& bytes, const std::string& path) {
  Heading heading;
  std::size_t at = bytes.find('\n') + 1;
  while (true) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) throw damaged(path, "its heading does not end");
    const std::string line = bytes.substr(at, end - at);
    at = end + 1;
    if (line.empty()) break;
    const std::size_t sign = line.find(" = ");
    if (sign == std::string::npos) throw damaged(path, "a line without a value in its heading");
    const std::string key = line.substr(0, sign), value = line.substr(sign + 3);
    const auto whole = [&](int low, int high) {
      return static_cast<int>(number_of(value, low, high, path, key));
    };
    if (key == "version") heading.version = whole(1, 1'000'000);
    if (key == "features") heading.features = value;
    if (key == "scales") heading.model.scales = whole(2, 100);
    if (key == "averaged") heading.model.factor = whole(1, 10'000);
    if (key == "pixel_size_m") heading.model.pixel_size = number_of(value, 0, 1e6, path, key);
    if (key == "evens_light") heading.model.evens_light = whole(0, 1) == 1;
    if (key == "trees") heading.trees = whole(1, 100'000);
    if (key == "phase") heading.model.phases.push_back(value);
  }
  heading.length = at;
  return heading;
}

void check_heading(const Heading& heading, const std::string& path) {
  if (heading.version != model_version)
    throw Error(path, "is a model of version " + std::to_string(heading.version),
                "this program reads version " + std::to_string(model_version), teach_anew);
  if (heading.features != feature_set || heading.model.scales > PixelFeatures::most_scales)
    throw Error(path,
                "was taught with the features " + heading.features + ", " +
                    std::to_string(heading.model.scales) + " scales",
                std::string("this program has the features ") + feature_set + ", at most " +
                    std::to_string(PixelFeatures::most_scales) + " scales",
                teach_anew);
  if (heading.model.phases.size() < 2 || heading.model.phases.size() > 254)
    throw damaged(path, "it names no two phases");
}

/// Every walk must end, and at a leaf that is there.
void check_forest(const Forest& forest, const std::string& path) {
  const auto nodes = static_cast<std::int64_t>(forest.nodes.size());
  for (const std::int32_t root : forest.roots)
    if (root < 0 || root >= nodes) throw damaged(path, "a tree without a root");
  for (std::int64_t i = 0; i < nodes; ++i) {
    const TreeNode& node = forest.nodes[static_cast<std::size_t>(i)];
    const bool is_leaf = node.leaf >= 0;
    if (node.feature >= forest.features || std::isnan(node.threshold))
      throw damaged(path, "a node without a feature");
    if (is_leaf && (node.next != i || !std::isinf(node.threshold) || node.threshold < 0))
      throw damaged(path, "a leaf that leads on");
    if (is_leaf && node.leaf + std::int64_t{forest.classes} > static_cast<std::int64_t>(forest.shares.size()))
      throw damaged(path, "a leaf without shares");
    if (!is_leaf && (node.next <= i || node.next + std::int64_t{1} >= nodes))
      throw damaged(path, "a node that leads back");
  }
  for (const float share : forest.shares)
    if (!(share >= 0 && share <= 1)) throw damaged(path, "a share that is none");
}

}  // namespace

std::string encode_model(const TaughtModel& model) {
  ByteWriter out;
  out.bytes = words_of(model);
  const Forest& forest = model.forest;
  out.number(static_cast<std::uint32_t>(forest.nodes.size()));
  out.number(static_cast<std::uint32_t>(forest.shares.size()));
  for (const std::int32_t root : forest.roots) out.number(static_cast<std::uint32_t>(root));
  for (const TreeNode& node : forest.nodes) {
    out.number(node.threshold);
    out.number(std::uint32_t{node.feature});
    out.number(static_cast<std::uint32_t>(node.next));
    out.number(static_cast<std::uint32_t>(node.leaf));
  }
  for (const float share : forest.shares) out.number(share);
  return out.bytes + sha256_of_text(out.bytes);
}

TaughtModel decode_model(const std::string& bytes, const std::string& path) {
  if (!bytes.starts_with(std::string(first_line) + "\n"))
    throw Error(path, "is no model of mesopix", "mesopix convert --save-model writes them");
  Heading heading = heading_of(bytes, path);
  check_heading(heading, path);
  if (bytes.size() < heading.length + digest_length) throw damaged(path, "it ends too soon");
  const std::size_t end = bytes.size() - digest_length;
  if (sha256_of_text(std::string_view(bytes).substr(0, end)) != std::string_view(bytes).substr(end))
    throw damaged(path, "its digest does not fit");
  ByteReader in(bytes, heading.length, end);
  Forest& forest = heading.model.forest;
  forest.classes = static_cast<int>(heading.model.phases.size());
  forest.features = PixelFeatures::count_of(heading.model.scales);
  if (!in.holds(2)) throw damaged(path, "it ends too soon");
  const std::uint64_t nodes = in.number(), shares = in.number();
  if (!in.holds(static_cast<std::uint64_t>(heading.trees) + 4 * nodes + shares))
    throw damaged(path, "it ends too soon");
  for (int i = 0; i < heading.trees; ++i) forest.roots.push_back(static_cast<std::int32_t>(in.number()));
  for (std::uint64_t i = 0; i < nodes; ++i) {
    TreeNode node;
    node.threshold = in.real();
    const std::uint32_t feature = in.number();
    if (feature >= static_cast<std::uint32_t>(forest.features))
      throw damaged(path, "a node without a feature");
    node.feature = static_cast<std::uint16_t>(feature);
    node.next = static_cast<std::int32_t>(in.number());
    node.leaf = static_cast<std::int32_t>(in.number());
    forest.nodes.push_back(node);
  }
  for (std::uint64_t i = 0; i < shares; ++i) forest.shares.push_back(in.real());
  if (!in.is_at_end()) throw damaged(path, "it goes on after its end");
  check_forest(forest, path);
  return std::move(heading.model);
}

TaughtModel read_model(const std::string& path) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))  // a pipe may never end
    throw Error(path, "is not a regular file", "must be a file that mesopix convert --save-model wrote", {},
                Fault::write);
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::int64_t length = stream ? static_cast<std::int64_t>(stream.tellg()) : -1;
  if (length > largest_file)
    throw Error(path, "is no model of mesopix", "mesopix convert --save-model writes them");
  std::string bytes(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  stream.seekg(0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (length < 0 || !stream)
    throw Error(path, "cannot be read", "must be a file that mesopix convert --save-model wrote", {},
                Fault::write);
  return decode_model(bytes, path);
}

}  // namespace specimen
