// Writes what the fuzzer begins with: a small good file of every kind that is read. Usage: write_fuzz_seeds
// FOLDER
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "libmpm/files/checkpoint_file.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/fuzz/checkpoint_samples.hpp"
#include "tests/specimen/jpeg_recipe.hpp"
#include "tests/specimen/png_recipe.hpp"
#include "tests/specimen/sample_specimen.hpp"
#include "tests/specimen/tiff_recipe.hpp"

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

fs::path folder_of(const fs::path& seeds, const char* kind) {
  fs::create_directories(seeds / kind);
  return seeds / kind;
}

void write(const fs::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write(const fs::path& path, const std::string& text) { write(path, Bytes(text.begin(), text.end())); }

/// Values without a pattern, the same every time.
Bytes values(std::size_t count, unsigned most = 255) {
  Bytes bytes;
  for (unsigned i = 0; bytes.size() < count; ++i)
    bytes.push_back(static_cast<std::uint8_t>((i * 2654435761U >> 24U) % (most + 1)));
  return bytes;
}

void write_pngs(const fs::path& folder) {
  write(folder / "gray.png",
        specimen_test::make_png({12, 10, 8, PNG_COLOR_TYPE_GRAY, false, values(120), {}, {}}));
  write(folder / "deep.png",
        specimen_test::make_png({6, 4, 16, PNG_COLOR_TYPE_RGB, true, values(144), {}, {}}));
  write(folder / "opaque.png",
        specimen_test::make_png({5, 5, 8, PNG_COLOR_TYPE_RGB_ALPHA, false, values(100), {}, {}}));
  write(folder / "palette.png", specimen_test::make_png({8,
                                                         8,
                                                         8,
                                                         PNG_COLOR_TYPE_PALETTE,
                                                         false,
                                                         values(64, 2),
                                                         {{9, 8, 7}, {60, 50, 40}, {250, 0, 0}},
                                                         {255, 9}}));
}

void write_tiffs(const fs::path& folder) {
  specimen_test::TiffRecipe recipe;
  recipe.cols = 20, recipe.rows = 18;
  const Bytes gray = values(360), colour = values(1080);
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
    recipe.compression = compression;
    specimen_test::write_tiff(folder / ("strips" + std::to_string(compression) + ".tif"), recipe, gray);
  }
  recipe.tile = 16;
  specimen_test::write_tiff(folder / "tiles.tif", recipe, gray);
  recipe.tile = 0;
  recipe.photometric = PHOTOMETRIC_PALETTE;
  specimen_test::write_tiff(folder / "palette.tif", recipe, gray);
  recipe.photometric = PHOTOMETRIC_RGB;
  recipe.samples = 3;
  specimen_test::write_tiff(folder / "colour.tif", recipe, colour);
  specimen::write_imagej_tiff(folder / "float.tif", specimen::Raster<float>(4, 5, 0.5F), 1e-3);
}

void write_pictures(const fs::path& folder) {
  write_pngs(folder);
  write_tiffs(folder);
  write(folder / "colour.jpg",
        specimen_test::make_jpeg({JCS_RGB, {{200, 40, 40}, {40, 200, 40}, {40, 40, 200}, {9, 9, 9}}}));
  write(folder / "progressive.jpg",
        specimen_test::make_jpeg({JCS_GRAYSCALE, {{10}, {90}, {170}, {250}}, 16, true}));
  specimen::LabelledMask mask = test::sample_specimen().mask;
  for (const char* name : {"labels.bmp", "labels.pgm", "labels.png", "labels.tif"})
    specimen::write_labels(folder / name, mask);
  write(folder / "text.pgm", "P2 # grey\n4 2 9\n1 2 3 4\n5 6 7 9\n");
  write(folder / "colour.ppm", "P6 2 1 255\nabcdef");
}

void write_scenes(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(MESOPIX_SOURCE_DIR "/data"))
    if (entry.path().extension() == ".toml")
      fs::copy_file(entry.path(), folder / entry.path().filename(), fs::copy_options::overwrite_existing);
  write(folder / "ellipses.toml",
        "[[ellipses]]\nx = \"10 mm\"\ny = \"12 mm\"\na = \"3 mm\"\nb = \"2 mm\"\nangle = \"30 deg\"\n");
  write(folder / "lists.toml",
        "[convert]\ncrop = [1, 2, 3, 4]\nthresholds = [1.5, 2e2]\nlabel_phases = [\"0:void\", \"1:mortar\"]\n"
        "[generate]\nclasses = [\"5 mm .. 10 mm: 40 %\", \"2 mm .. 5 mm: 60 %\"]\n[phases.fibre]\nyoung = "
        "\"2 GPa\"\n");
}

void write_lists(const fs::path& folder) {
  write(folder / "list.csv", "x_mm,y_mm,a_mm,b_mm,angle_deg\n10,12,4,3,30\n# no more\n25,20,5,2,-10\n");
  write(folder / "bare.csv",
        "\xEF\xBB\xBF"
        "b_m, a_m, x_um, y_cm\r\n0.001, 0.002, 9000, 1.5\r\n");
}

/// The number of the scene, and the file.
void write_checkpoints(const fs::path& folder) {
  const std::vector<mpm::Scene> scenes = fuzz::checkpoint_scenes();
  const fs::path file = folder / "file";
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const int rows : {2, 20}) {
      const auto checkpoint = fuzz::checkpoint_after(scenes[i], rows);
      if (!checkpoint) continue;
      mpm::write_checkpoint(file, *checkpoint, "", "");
      std::string bytes(1, static_cast<char>(i));
      std::ifstream stream(file, std::ios::binary);
      bytes.append(std::istreambuf_iterator<char>(stream), {});
      write(folder / (std::to_string(i) + "_after_" + std::to_string(rows)), bytes);
    }
  fs::remove(file);
}

void write_all(const fs::path& seeds) {
  write_pictures(folder_of(seeds, "picture"));
  write_scenes(folder_of(seeds, "scene"));
  write_lists(folder_of(seeds, "ellipse_list"));
  write_checkpoints(folder_of(seeds, "checkpoint"));
  // Changes of a good file.
  for (const char* kind : {"specimen_file", "result_file", "frame_file"})
    write(folder_of(seeds, kind) / "edits", values(300));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: write_fuzz_seeds FOLDER\n";
    return 64;
  }
  write_all(arguments[1]);
  return 0;
}
