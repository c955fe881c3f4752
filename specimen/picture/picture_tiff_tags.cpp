#include "specimen/picture/picture_tiff_tags.hpp"

#include <charconv>
#include <map>
#include <string>

#include "specimen/picture/picture_codecs.hpp"

namespace specimen {

int short_tag(TIFF* tiff, std::uint32_t tag, int otherwise) {
  std::uint16_t value = 0;
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : otherwise;
}

std::string_view description_of(TIFF* tiff) {
  const char* description = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &description) != 1 || description == nullptr) return {};
  return description;
}

namespace {

/// Length of a unit [m]; 0 = it is not known. The micro sign comes as U+00B5, in Latin-1, escaped, and as the
/// Greek letter U+03BC.
double unit_named(std::string_view name) {
  static const std::map<std::string_view, double> units{
      {"nm", 1e-9},       {"um", 1e-6},        {"\\u00B5m", 1e-6}, {"\\u03BCm", 1e-6},  {"\\u00b5m", 1e-6},
      {"\\u03bcm", 1e-6}, {"\xc2\xb5m", 1e-6}, {"\xb5m", 1e-6},    {"\xce\xbcm", 1e-6}, {"micron", 1e-6},
      {"microns", 1e-6},  {"mm", 1e-3},        {"cm", centimetre}, {"dm", 0.1},         {"m", 1},
      {"in", inch},       {"inch", inch},      {"inches", inch}};
  const auto unit = units.find(name);
  return unit == units.end() ? 0 : unit->second;
}

bool is_imagej(std::string_view description) { return description.starts_with("ImageJ="); }

}  // namespace

std::string_view imagej_value(std::string_view description, std::string_view key) {
  const std::string line = "\n" + std::string(key) + "=";
  const std::size_t at = description.find(line);
  if (!is_imagej(description) || at == std::string_view::npos) return {};
  const std::string_view rest = description.substr(at + line.size());
  return rest.substr(0, rest.find('\n'));
}

namespace {

/// Unit of length in a description by ImageJ, which overrides the tag [m]; 0 = there is none that is known.
/// "um" beside a tag of centimetres is what ImageJ is to show, and the resolution is per centimetre: so does
/// ImageJ 1.53t read it, and with no other pair of a unit and a tag.
double unit_of_resolution(TIFF* tiff) {
  const int unit = short_tag(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  const std::string_view shown = imagej_value(description_of(tiff), "unit");
  if (shown == "um" && unit == RESUNIT_CENTIMETER) return centimetre;
  if (const double described = unit_named(shown); described > 0) return described;
  if (unit == RESUNIT_CENTIMETER) return centimetre;
  return unit == RESUNIT_INCH ? inch : 0;
}

/// An attribute of OME-XML, as 'name="value"'; empty = there is none.
std::string_view ome_attribute(std::string_view xml, const std::string& name) {
  const std::string start = " " + name + "=";
  const std::size_t at = xml.find(start);
  if (at == std::string_view::npos || at + start.size() >= xml.size()) return {};
  const char quote = xml[at + start.size()];
  const std::string_view rest = xml.substr(at + start.size() + 1);
  if (quote != '"' && quote != '\'') return {};
  return rest.substr(0, rest.find(quote));
}

/// Length of a pixel along an axis in OME-XML [m]; 0 = unknown.
double ome_length(std::string_view xml, char axis) {
  const std::string name = std::string("PhysicalSize") + axis;
  const std::string value(ome_attribute(xml, name));
  const std::string_view unit = ome_attribute(xml, name + "Unit");
  double length = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), length);
  if (error != std::errc() || end != value.data() + value.size()) return 0;
  return length * (unit.empty() ? 1e-6 : unit_named(unit));
}

}  // namespace

PixelShape tiff_pixel_shape(TIFF* tiff) {
  const std::string_view description = description_of(tiff);
  if (description.find("<OME") != std::string_view::npos) {
    const double x = ome_length(description, 'X'), y = ome_length(description, 'Y');
    if (x > 0 && y > 0) return pixel_shape_of(1 / x, 1 / y);
  }
  float x = 0, y = 0;
  if (TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &x) != 1 || TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &y) != 1)
    return {};
  const double unit = unit_of_resolution(tiff);
  const double length = unit > 0 ? unit : 1;
  PixelShape shape = pixel_shape_of(static_cast<double>(x) / length, static_cast<double>(y) / length);
  if (unit == 0) shape.width = 0;  // a ratio alone
  return shape;
}

void read_tiff_words(TIFF* tiff, Picture& picture) {
  const std::string_view description = description_of(tiff);
  const std::string_view start = "mesopix ";
  if (description.starts_with(start)) set_origin(picture, description.substr(start.size()));
  set_origin(picture, imagej_value(description, own_keyword));
}

}  // namespace specimen
