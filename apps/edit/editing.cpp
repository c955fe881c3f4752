#include "apps/edit/editing.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "apps/scene/stroke_list.hpp"
#include "apps/system/browser.hpp"
#include "apps/system/processes.hpp"
#include "specimen/convert/convert_options.hpp"
#include "specimen/convert/segment_taught.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

/// A picture that no other program of ours may edit; file systems without locks hold nothing.
class HeldPicture {
 public:
  explicit HeldPicture(const std::string& picture)
      : descriptor_(::open(picture.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      throw Rejected(Exit::interrupted, "--edit", picture, "is being edited by another mesopix",
                     "go on there, or end it");
    }
  }
  HeldPicture(const HeldPicture&) = delete;
  HeldPicture& operator=(const HeldPicture&) = delete;
  ~HeldPicture() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

 private:
  int descriptor_;
};

/// What has no meaning beside strokes that are drawn.
void check_settings(specimen::ConvertOptions options) {
  if (!options.model.empty())
    throw Rejected(Exit::usage, "--edit", "given with convert.model", "a model needs no strokes",
                   "leave one of the two out");
  if (options.method != specimen::Segmentation::automatic && options.method != specimen::Segmentation::taught)
    throw Rejected(Exit::usage, "--edit",
                   "given with convert.method = " + specimen::method_name(options.method),
                   "strokes belong to method taught", "leave one of the two out");
  options.strokes.clear();
  options.label_phases.clear();
  options.stroke_lines = {{"mortar", 1, {{0, 0}}}};
  specimen::check_options(options);
}

std::vector<specimen::StrokeLine> strokes_of(const specimen::ConvertOptions& options,
                                             const specimen::Picture& picture) {
  if (holds_lines(options.strokes)) return read_stroke_list(options.strokes);
  return lines_of(specimen::strokes_for(picture, options));
}

bool is_same_file(const std::string& one, const std::string& other) {
  std::error_code error;
  return fs::equivalent(one, other, error) && !error;
}

}  // namespace

std::string strokes_file_for(const std::string& picture, const std::string& output) {
  const fs::path path(picture);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const fs::path name = path.stem().string() + ".strokes.csv";
  const bool can_write = ::access(folder.c_str(), W_OK) == 0;
  return (can_write ? path.parent_path() / name : fs::path(output).parent_path() / name).string();
}

EditBeginning begin_to_edit(const Settings& settings, std::vector<Assignment> given,
                            const std::string& file) {
  check_settings(settings.convert);
  const std::string& strokes = settings.convert.strokes;
  const bool has_left_some = fs::exists(file);
  if (!strokes.empty() && has_left_some && !is_same_file(strokes, file))
    throw Rejected(Exit::usage, "--strokes", strokes, file + " has the strokes of an earlier page",
                   "leave --strokes out to go on with these, or move that file away");
  EditBeginning beginning;
  beginning.picture = specimen::read_picture(settings.specimen.picture, settings.convert.max_pixels);
  if (beginning.picture.origin == specimen::Origin::drawing)
    throw Rejected(Exit::data, "specimen.picture", "a drawing of mesopix, made to be looked at",
                   "must show a specimen", "edit the picture that the specimen was made from");
  if (!strokes.empty())
    beginning.lines = strokes_of(settings.convert, beginning.picture);
  else if (has_left_some)
    beginning.lines = read_stroke_list(file);
  std::erase_if(given, [&](const Assignment& one) {
    return one.key == "convert.strokes" || (!strokes.empty() && one.key == "convert.label_phases");
  });
  beginning.given = std::move(given);
  return beginning;
}

namespace {

/// Makes what the page wishes for; whether a specimen came of it.
bool fulfil(EditSession& session, const Maker& make, Console& console) {
  try {
    session.made(make(session.wanted()));
    return true;
  } catch (...) {
    const Rejected refusal = refusal_of(std::current_exception(), console.locate);
    session.failed(refusal.what());
    console.warn(refusal.what());
    return false;
  }
}

}  // namespace

Exit edit_picture(const std::string& picture, EditTask task, StrokeBook book, int port, const Maker& make,
                  Console& console) {
  constexpr std::chrono::milliseconds look_for_signals{100};
  const HeldPicture held(picture);
  book.keep();
  const std::string file = book.file();
  const InterruptGuard guard;
  bool has_made = false;
  {
    EditSession session(std::move(task), std::move(book));
    const LiveServer server(port, session.answers());
    console.err << "edit the picture at " << server.address() << std::endl;
    const OpenedBrowser browser(server.address());
    while (!guard.interrupted()) {
      const EditWish wish = session.wait(look_for_signals);
      if (wish == EditWish::finish) break;
      if (wish == EditWish::make && fulfil(session, make, console)) has_made = true;
    }
    session.finish();
  }
  if (fs::exists(file)) console.say("the strokes are kept in " + file);
  if (!has_made) console.say("no specimen was made");
  return has_made ? Exit::ok : Exit::interrupted;
}

}  // namespace app
