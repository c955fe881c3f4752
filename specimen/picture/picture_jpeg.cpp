#include <cstddef>
#include <cstdio>

// jpeglib.h needs size_t and FILE before it.
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <utility>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"

// As with libpng: functions that call setjmp hold plain data alone.
namespace specimen {
namespace {

struct JpegErrors : jpeg_error_mgr {
  jmp_buf jump;
  std::array<char, JMSG_LENGTH_MAX> text;
};

[[noreturn]] void on_error(j_common_ptr jpeg) {
  auto* errors = static_cast<JpegErrors*>(jpeg->err);
  errors->format_message(jpeg, errors->text.data());
  longjmp(errors->jump, 1);
}

/// libjpeg goes on with grey where the data are damaged or end too early; a specimen must not.
void on_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  switch (jpeg->err->msg_code) {
    case JWRN_ADOBE_XFORM:
    case JWRN_EXTRANEOUS_DATA:
    case JWRN_JFIF_MAJOR:
    case JWRN_BOGUS_ICC:
      return;
    default:
      on_error(jpeg);
  }
}

/// A hostile progressive file repeats scans of the whole picture for hours; real ones have about ten.
void limit_scans(j_common_ptr jpeg) {
  auto* decompress = reinterpret_cast<j_decompress_ptr>(jpeg);
  if (decompress->input_scan_number > 200) ERREXIT(jpeg, JERR_BAD_PROGRESSION);
}

struct JpegReader {
  jpeg_decompress_struct jpeg{};
  JpegErrors errors{};
  jpeg_progress_mgr progress{};

  JpegReader() {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = on_error;
    errors.emit_message = on_message;
    progress.progress_monitor = limit_scans;
  }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
};

bool read_header(JpegReader& reader, std::FILE* file) {
  if (setjmp(reader.errors.jump) != 0) return false;
  jpeg_create_decompress(&reader.jpeg);
  reader.jpeg.progress = &reader.progress;
  jpeg_stdio_src(&reader.jpeg, file);
  jpeg_save_markers(&reader.jpeg, JPEG_APP0 + 1, 0xffff);
  jpeg_read_header(&reader.jpeg, TRUE);
  return true;
}

bool start(JpegReader& reader) {
  if (setjmp(reader.errors.jump) != 0) return false;
  switch (reader.jpeg.jpeg_color_space) {
    case JCS_GRAYSCALE:
      reader.jpeg.out_color_space = JCS_GRAYSCALE;
      break;
    case JCS_CMYK:
    case JCS_YCCK:
      reader.jpeg.out_color_space = JCS_CMYK;
      break;
    default:
      reader.jpeg.out_color_space = JCS_RGB;
  }
  jpeg_start_decompress(&reader.jpeg);
  return true;
}

bool read_row(JpegReader& reader, JSAMPROW row) {
  if (setjmp(reader.errors.jump) != 0) return false;
  jpeg_read_scanlines(&reader.jpeg, &row, 1);
  return true;
}

bool finish(JpegReader& reader) {
  if (setjmp(reader.errors.jump) != 0) return false;
  jpeg_finish_decompress(&reader.jpeg);
  return true;
}

/// Ink to light. Adobe's programs store ink upside down and say so by their marker.
Rgb from_cmyk(const std::uint8_t* p, bool inverted) {
  const auto light = [&](int ink, int black) {
    const int a = inverted ? ink : 255 - ink, k = inverted ? black : 255 - black;
    return static_cast<std::uint8_t>((a * k + 127) / 255);
  };
  return {light(p[0], p[3]), light(p[1], p[3]), light(p[2], p[3])};
}

ExifTags exif(const JpegReader& reader) {
  for (const jpeg_marker_struct* m = reader.jpeg.marker_list; m != nullptr; m = m->next)
    if (m->marker == JPEG_APP0 + 1) {
      const ExifTags tags = read_exif({m->data, m->data_length});
      if (tags.orientation != 1 || tags.shape.width > 0) return tags;
    }
  return {};
}

PixelShape jfif_shape(const jpeg_decompress_struct& jpeg) {
  if (!jpeg.saw_JFIF_marker) return {};
  const double unit = jpeg.density_unit == 2 ? centimetre : inch;
  PixelShape shape = pixel_shape_of(jpeg.X_density / unit, jpeg.Y_density / unit);
  if (jpeg.density_unit < 1 || jpeg.density_unit > 2) shape.width = 0;  // a ratio alone
  return shape;
}

void store_row(Picture& picture, Raster<std::uint8_t>& gray, int row, const Bytes& samples,
               const jpeg_decompress_struct& jpeg) {
  for (int c = 0; c < static_cast<int>(jpeg.output_width); ++c) {
    const std::uint8_t* p =
        &samples[static_cast<std::size_t>(c) * static_cast<std::size_t>(jpeg.output_components)];
    if (jpeg.out_color_space == JCS_GRAYSCALE)
      gray(row, c) = *p;
    else if (jpeg.out_color_space == JCS_CMYK)
      picture.colour(row, c) = from_cmyk(p, jpeg.saw_Adobe_marker != 0);
    else
      picture.colour(row, c) = {p[0], p[1], p[2]};
  }
}

}  // namespace

Picture read_jpeg(const PictureSource& source) {
  JpegReader reader;
  const auto damaged = [&] {
    return bad_picture(source.path, std::string("is a damaged JPEG: ") + reader.errors.text.data());
  };
  if (!read_header(reader, source.file.get())) throw damaged();
  const std::int64_t n_rows = reader.jpeg.image_height, n_cols = reader.jpeg.image_width;
  // A block takes a bit at least, and at the coarsest sampling it covers 32 x 32 pixels.
  check_size(source, n_rows, n_cols, n_rows * n_cols / (8 * 32 * 32));
  if (!start(reader)) throw damaged();

  Picture picture;
  const ExifTags tags = exif(reader);
  picture.lossy = true;
  set_shape(picture, jfif_shape(reader.jpeg));
  if (picture.pixel_size == 0 && tags.shape.width > 0) set_shape(picture, tags.shape);
  const int rows = static_cast<int>(reader.jpeg.output_height),
            cols = static_cast<int>(reader.jpeg.output_width);
  Raster<std::uint8_t> gray;
  if (reader.jpeg.out_color_space == JCS_GRAYSCALE)
    gray = Raster<std::uint8_t>(rows, cols);
  else
    picture.colour = Raster<Rgb>(rows, cols);
  Bytes samples(static_cast<std::size_t>(cols) * static_cast<std::size_t>(reader.jpeg.output_components));
  for (int row = 0; row < rows; ++row) {
    if (!read_row(reader, samples.data())) throw damaged();
    store_row(picture, gray, row, samples, reader.jpeg);
  }
  if (!finish(reader)) throw damaged();
  picture.gray = std::move(gray);
  return upright(std::move(picture), tags.orientation);
}

}  // namespace specimen
