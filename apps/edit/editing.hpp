/// Teaching a picture on a page, from its beginning to its end.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/edit/edit_session.hpp"
#include "apps/system/terminal.hpp"

namespace app {

/// File of the strokes that a page is working on: PICTURE with .strokes.csv, beside it; beside the output
/// where the folder of the picture cannot be written.
[[nodiscard]] std::string strokes_file_for(const std::string& picture, const std::string& output);

/// A picture, and with what the page begins.
struct EditBeginning {
  specimen::Picture picture;
  std::vector<specimen::StrokeLine> lines;
  std::vector<Assignment> given;  ///< without strokes, and without the names of their colours
};

/// Read the picture and the strokes to begin with: those of the settings, or those that an earlier page left.
/// @param settings  of the picture.   @param given  of the command line.   @param file  of
/// strokes_file_for().
/// @throws Rejected for settings that do not go with strokes, and where the settings name strokes although an
/// earlier page left some; specimen::Error.
[[nodiscard]] EditBeginning begin_to_edit(const Settings& settings, std::vector<Assignment> given,
                                          const std::string& file);

/// Makes a specimen; what it throws is told on the page.
using Maker = std::function<Made(const EditSession::Wanted& wanted)>;

/// Serve the page until the person finishes or a signal ends the program. Its address is told on the
/// terminal, and opened in a browser where there is a screen.
/// @param picture  path, which no other program of ours may edit meanwhile.   @param port  0 = any.
/// @return ok, or interrupted where no specimen was made.   @throws Rejected.
[[nodiscard]] Exit edit_picture(const std::string& picture, EditTask task, StrokeBook book, int port,
                                const Maker& make, Console& console);

}  // namespace app
