/// A picture that a person teaches on a page: strokes, settings, and what they make of the picture.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "apps/edit/shown_mask.hpp"
#include "apps/edit/stroke_book.hpp"
#include "apps/live/live_server.hpp"
#include "apps/settings/assignment.hpp"
#include "specimen/convert/sketch.hpp"

namespace app {

/// Settings that the page has controls for, in their order there.
[[nodiscard]] const std::vector<std::string>& edited_settings();

/// A specimen that was made.
struct Made {
  std::vector<std::string> files;          ///< the strokes among them
  std::string strokes;                     ///< file of the strokes that it was made with
  std::string command;                     ///< makes the same specimen without the page
  nlohmann::ordered_json figures;          ///< as specimen_json() has them
  double uncertain = specimen::not_known;  ///< share of the area [-]
  std::vector<std::string> notes;
  specimen::Segmented segmentation;             ///< before rings were drawn
  specimen::Raster<std::uint8_t> uncertain_at;  ///< as of specimen::Converted
};

/// What the program is told.
struct EditTask {
  specimen::Picture picture;
  std::string name;               ///< of the picture, for the title
  specimen::Crop crop;            ///< the part of it that becomes the specimen
  std::vector<Assignment> given;  ///< settings as options of the command line
  /// Settings with others in place of those that were given.   @throws Rejected
  std::function<Settings(const std::vector<Assignment>& given)> settle;
};

/// What the person on the page wants of the program.
enum class EditWish { none, make, finish };

/// Called from the threads of a server, several at a time, and from the thread that makes specimens; a thread
/// of its own sorts a sketch of the picture whenever strokes or settings have changed.
class EditSession {
 public:
  EditSession(EditTask task, StrokeBook book);
  ~EditSession();
  EditSession(const EditSession&) = delete;
  EditSession& operator=(const EditSession&) = delete;

  /// What the page asks for, and what it may order.
  [[nodiscard]] LiveAnswers answers();

  /// Waits for a wish, or so long.
  [[nodiscard]] EditWish wait(std::chrono::milliseconds at_most);

  /// What a specimen is to be made of, now.
  struct Wanted {
    std::vector<specimen::StrokeLine> lines;
    std::vector<Assignment> given;
  };
  /// The answer to the wish to make a specimen: made() or failed() must follow.
  [[nodiscard]] Wanted wanted();
  void made(Made made);
  void failed(const std::string& why);

  /// Waits until pages have been told of the end, or for a second.
  void finish();

 private:
  struct Sketched;

  [[nodiscard]] std::optional<std::string> update(std::int64_t have);
  [[nodiscard]] nlohmann::ordered_json state() const;
  [[nodiscard]] nlohmann::ordered_json strokes_json() const;
  [[nodiscard]] nlohmann::ordered_json settings_json() const;
  LiveReply change(const std::string& content, const std::function<void(const nlohmann::json& order)>& apply);
  void add(const nlohmann::json& order);
  void remove(const nlohmann::json& order);
  void set(const nlohmann::json& order);
  void want_to_make();
  void work();
  [[nodiscard]] Sketched sort(const std::vector<specimen::StrokeLine>& lines, const Settings& settings) const;
  void touch();

  EditTask task_;
  specimen::Sketch sketch_;
  ShownPicture shown_;
  std::mutex mutable mutex_;  ///< of all that follows
  std::condition_variable changed_;
  StrokeBook book_;
  std::vector<Assignment> given_;
  Settings settings_;
  std::int64_t number_ = 1;  ///< of what pages know; grows with every change
  std::int64_t told_ = 0;    ///< newest number that a page has got
  std::int64_t wanted_ = 1;  ///< grows with every change of strokes or settings
  std::int64_t sorted_ = 0;  ///< what the mask shows
  std::int64_t mask_version_ = 0;
  std::shared_ptr<const ShownMask> mask_;
  nlohmann::ordered_json found_;  ///< about the mask
  std::optional<Made> made_;
  std::int64_t made_of_ = 0;  ///< wanted_ when that began
  std::string fault_;         ///< of the specimen that could not be made
  EditWish wish_ = EditWish::none;
  bool is_making_ = false, has_ended_ = false, ends_ = false;
  std::thread worker_;  ///< last: it ends first
};

}  // namespace app
