#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"

namespace specimen {
namespace {

constexpr std::size_t longest_comment = 10'000;  ///< that is looked at [bytes]
const std::string own_comment = "# mesopix ";

/// The numbers of a PNM file, in text or in bytes.
class PnmReader {
 public:
  explicit PnmReader(const PictureSource& source) : source_(source) {}

  int next() { return std::fgetc(source_.file.get()); }

  /// Next decimal number, past blanks and comments (# to the end of the line); takes the one character after
  /// it, as the format wants.
  int text_number() {
    int c = next();
    while (c == '#' || std::isspace(c) != 0) {
      if (c == '#') {
        std::string comment;
        while (c != '\n' && c != EOF) {
          if (comment.size() < longest_comment) comment += static_cast<char>(c);
          c = next();
        }
        if (comment.starts_with(own_comment)) own_words_ = comment.substr(own_comment.size());
      }
      c = next();
    }
    if (c == EOF) throw bad_picture(source_.path, "is truncated: the file ends before its last pixel");
    if (std::isdigit(c) == 0) throw bad_picture(source_.path, "is a damaged PNM: a number was expected");
    std::int64_t value = 0;
    for (; std::isdigit(c) != 0; c = next()) {
      value = value * 10 + (c - '0');
      if (value > INT32_MAX) throw bad_picture(source_.path, "is a damaged PNM: a number is too large");
    }
    return static_cast<int>(value);
  }

  /// What this program has written into the comment.
  [[nodiscard]] const std::string& words() const { return own_words_; }

  /// Whether another picture begins where the file stands.
  bool another_follows() {
    int c = next();
    while (std::isspace(c) != 0) c = next();
    return c == 'P' && std::isdigit(next()) != 0;
  }

 private:
  const PictureSource& source_;
  std::string own_words_;
};

struct PnmHeader {
  bool colour = false, text = false;
  int rows = 0, cols = 0, max = 0;
  [[nodiscard]] int channels() const { return colour ? 3 : 1; }
  [[nodiscard]] int bytes_a_value() const { return max > 255 ? 2 : 1; }
};

PnmHeader read_header(PnmReader& reader, const PictureSource& source) {
  PnmHeader header;
  reader.next();  // 'P'
  const int kind = reader.next();
  if (kind != '2' && kind != '3' && kind != '5' && kind != '6')
    throw Error(source.path, std::string("is a PNM of kind P") + static_cast<char>(kind),
                "grey P2, P5 and colour P3, P6 are read", "save it as PGM, PPM or PNG");
  header.colour = kind == '3' || kind == '6';
  header.text = kind <= '3';
  header.cols = reader.text_number();
  header.rows = reader.text_number();
  header.max = reader.text_number();
  if (header.max < 1 || header.max > 65535)
    throw Error(source.path, "largest value " + std::to_string(header.max), "1 to 65535 is allowed");
  return header;
}

/// One row of values, as they stand in the file.
void read_row(PnmReader& reader, const PictureSource& source, const PnmHeader& header,
              std::vector<int>& values) {
  if (header.text) {
    for (int& value : values) value = reader.text_number();
  } else {
    const auto width = static_cast<std::size_t>(header.bytes_a_value());
    Bytes bytes(values.size() * width);
    read_exactly(source, bytes.data(), bytes.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = width == 2 ? bytes[2 * i] * 256 + bytes[2 * i + 1] : bytes[i];
  }
  for (const int value : values)
    if (value > header.max)
      throw Error(source.path, "pixel value " + std::to_string(value),
                  "the header allows at most " + std::to_string(header.max));
}

using Values = Raster<std::uint16_t>;  ///< of a row and its channels side by side

/// Grey values as they stand in the file; colours as shares of the largest value.
void set_pixels(Picture& picture, const PnmHeader& header, const Values& values) {
  const auto step = static_cast<std::size_t>(header.channels());
  const auto is_gray = [&] {
    for (std::size_t i = 0; i < values.size(); i += step)
      if (values.data[i] != values.data[i + step - 1] || values.data[i] != values.data[i + step / 2])
        return false;
    return true;
  };
  if (is_gray()) {
    const auto fill = [&](auto gray) {
      using T = typename decltype(gray.data)::value_type;
      for (std::size_t i = 0; i < gray.size(); ++i) gray.data[i] = static_cast<T>(values.data[i * step]);
      return gray;
    };
    if (header.max > 255)
      picture.gray = fill(Raster<std::uint16_t>(header.rows, header.cols));
    else
      picture.gray = fill(Raster<std::uint8_t>(header.rows, header.cols));
    return;
  }
  DeepToByte deep;
  for (const std::uint16_t value : values.data) deep.look_at(value);
  const auto byte = [&](std::size_t i) {
    if (header.max == 65535) return deep(values.data[i]);
    return static_cast<std::uint8_t>((values.data[i] * 255 + header.max / 2) / header.max);
  };
  picture.colour = Raster<Rgb>(header.rows, header.cols);
  for (std::size_t i = 0; i < picture.colour.size(); ++i)
    picture.colour.data[i] = {byte(3 * i), byte(3 * i + 1), byte(3 * i + 2)};
}

}  // namespace

Picture read_pnm(const PictureSource& source) {
  PnmReader reader(source);
  const PnmHeader header = read_header(reader, source);
  check_size(source, header.rows, header.cols, 0);
  // In text a value takes a digit and a blank, but the last one may end the file.
  const std::int64_t values = std::int64_t{header.rows} * header.cols * header.channels();
  check_size(source, header.rows, header.cols,
             header.text ? 2 * values - 1 : values * header.bytes_a_value());

  Picture picture;
  picture.bits = header.bytes_a_value() * 8;
  set_origin(picture, reader.words());
  Values pixels(header.rows, header.cols * header.channels());
  std::vector<int> row_values(static_cast<std::size_t>(pixels.cols));
  for (int row = 0; row < header.rows; ++row) {
    read_row(reader, source, header, row_values);
    std::transform(row_values.begin(), row_values.end(), &pixels(row, 0),
                   [](int value) { return static_cast<std::uint16_t>(value); });
  }
  set_pixels(picture, header, pixels);
  if (reader.another_follows()) throw several_pictures(source.path, "is a PNM of several pictures");
  return picture;
}

Bytes encode_pgm(const LabelledMask& mask) {
  const Raster<std::uint8_t>& labels = mask.labels;
  const std::string header = "P5\n" + own_comment + own_words(Origin::labels, mask.phases) + "\n" +
                             std::to_string(labels.cols) + " " + std::to_string(labels.rows) + "\n255\n";
  Bytes bytes(header.begin(), header.end());
  bytes.insert(bytes.end(), labels.data.begin(), labels.data.end());
  return bytes;
}

}  // namespace specimen
