/// A study whose members are broken in no time.
#pragma once

#include <string>

#include "apps/study/study_file.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace test {

/// A random specimen of 16 mm, and beside it a study of it in the folder.
inline void write_small_study(const std::string& folder, const std::string& study) {
  write_text(folder + "/scene.toml",
             "[generate]\nwidth = \"16 mm\"\nheight = \"16 mm\"\npixel_size = \"1 mm\"\nfraction = 0.3\n"
             "d_min = \"4 mm\"\nd_max = \"8 mm\"\n[loading]\nvelocity = \"0.2 m/s\"\nstop_drop = 0.3\n");
  write_text(folder + "/study.toml", "scene = \"scene.toml\"\n" + study);
}

inline app::Study small_study(const TemporaryFolder& folder, const std::string& study) {
  write_small_study(folder / "", study);
  return app::read_study(folder / "study.toml");
}

}  // namespace test
