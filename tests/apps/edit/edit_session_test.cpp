#include "apps/edit/edit_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "apps/scene/input.hpp"
#include "apps/scene/scene_file.hpp"
#include "tests/specimen/dressed.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace edit_session_test {

using app::EditSession;
using app::EditWish;
using nlohmann::json;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

/// A session over a photograph of stones, asked as its page asks.
class Session : public ::testing::Test {
 protected:
  void SetUp() override { begin({}); }

  void begin(std::vector<app::Assignment> given) {
    app::EditTask task;
    task.picture.colour = specimen_test::dressed(truth_.labels, 1);
    task.name = "photo.png";
    task.given = std::move(given);
    task.settle = [](const std::vector<app::Assignment>& all) {
      std::vector<app::Assignment> with = all;
      with.push_back(app::given_as_option("specimen.picture", app::Kind::path, "PICTURE", "photo.png"));
      return app::resolve({}, with).settings;
    };
    session_.emplace(std::move(task), app::StrokeBook((folder_ / "s.csv"), {}, truth_.rows, truth_.cols));
    answers_ = session_->answers();
  }

  [[nodiscard]] json state() { return json::parse(*answers_.update(-1)); }
  [[nodiscard]] app::LiveReply order(const char* name, const json& content = json::object()) {
    return answers_.orders.at(name)(content.dump());
  }
  void expect_refusal(const char* name, const json& content, const std::string& why) {
    const app::LiveReply reply = order(name, content);
    EXPECT_EQ(reply.status, 400) << content;
    EXPECT_THAT(json::parse(reply.body)["error"].get<std::string>(), HasSubstr(why));
  }
  /// As soon as the mask shows the strokes.
  [[nodiscard]] json sorted() {
    json now = state();
    for (; now["is_sorting"]; now = state()) std::this_thread::sleep_for(milliseconds(5));
    return now;
  }
  /// Strokes on stones and on mortar.
  void teach() {
    const auto strokes = specimen_test::some_strokes(truth_.labels, 4, 9);
    for (int r = 0; r < strokes.rows; ++r)
      for (int c = 0; c < strokes.cols; ++c) {
        const bool begins = strokes(r, c) < 3 && (r == 0 || strokes(r - 1, c) != strokes(r, c)) &&
                            (c == 0 || strokes(r, c - 1) != strokes(r, c));
        if (!begins) continue;
        EXPECT_EQ(order("add", {{"phase", specimen::standard_phases()[strokes(r, c)]},
                                {"width", 3},
                                {"points", {{c + 1.5, r + 0.5}, {c + 1.5, r + 8.5}}}})
                      .status,
                  200);
      }
  }

  specimen_test::KnownTruth truth_ = specimen_test::large_truth();
  test::TemporaryFolder folder_;
  std::optional<EditSession> session_;
  app::LiveAnswers answers_;
};

TEST_F(Session, BeginsWithoutAMaskAndSaysWhatIsMissing) {
  EXPECT_EQ(sorted()["mask_version"], 1);
  EXPECT_EQ(sorted()["found"]["why"], "");
  EXPECT_EQ(answers_.parts.at("mask")().status, 404);
  EXPECT_EQ(order("add", {{"phase", "mortar"}, {"width", 5}, {"points", {{10, 10}, {60, 10}}}}).status, 200);
  EXPECT_THAT(sorted()["found"]["why"].get<std::string>(), HasSubstr("at least two phases need a stroke"));
  EXPECT_FALSE(state()["has_scale"]);
}

TEST_F(Session, SortsThePictureByItsStrokes) {
  teach();
  const json now = sorted();
  ASSERT_TRUE(now["found"].contains("rows")) << now["found"];
  const int rows = now["found"]["rows"], cols = now["found"]["cols"];
  const std::string mask = answers_.parts.at("mask")().body;
  ASSERT_EQ(mask.size(), static_cast<std::size_t>(2 * rows * cols));
  ASSERT_EQ(rows, truth_.rows);
  int right = 0;
  for (std::size_t i = 0; i < truth_.labels.size(); ++i) right += mask[i] == truth_.labels.data[i];
  EXPECT_GT(right, 0.95 * static_cast<double>(truth_.labels.size()));
  EXPECT_GT(now["found"]["figures"]["aggregates"]["count"], 3);
  EXPECT_FALSE(now["found"]["figures"].contains("width_m")) << "there is no scale";
  EXPECT_EQ(answers_.parts.at("photo")().body.size(), 3 * truth_.labels.size());
}

TEST_F(Session, TellsNewsOnly) {
  const json now = sorted();
  EXPECT_FALSE(answers_.update(now["number"].get<std::int64_t>()));
  (void)order("add", {{"phase", "mortar"}, {"width", 5}, {"points", {{10, 10}}}});
  EXPECT_TRUE(answers_.update(now["number"].get<std::int64_t>()));
}

TEST_F(Session, RefusesBadOrdersAndLosesNothing) {
  (void)order("add", {{"phase", "mortar"}, {"width", 5}, {"points", {{10, 10}}}});
  const json before = state();
  EXPECT_EQ(answers_.orders.at("add")("{").status, 400);
  EXPECT_EQ(answers_.orders.at("add")("[1]").status, 400);
  EXPECT_EQ(answers_.orders.at("add")(std::string(100'000, '[')).status, 400);
  expect_refusal("add", {{"phase", "mortar"}}, "missing");
  expect_refusal("add", {{"phase", "mortar"}, {"width", "x"}, {"points", json::array()}}, "of another type");
  expect_refusal("add", {{"phase", "mortar"}, {"width", 5}, {"points", {{1}}}}, "missing");
  expect_refusal("add", {{"phase", "no name"}, {"width", 5}, {"points", {{1, 1}}}}, "name of a phase");
  expect_refusal("add", {{"phase", "mortar"}, {"width", 5}, {"points", {{1, 1e9}}}}, "lie on the picture");
  expect_refusal("remove", {{"version", 1}, {"strokes", {0}}}, "have changed in the meantime");
  expect_refusal("remove", {{"version", before["version"]}, {"strokes", {7}}}, "must be one of");
  expect_refusal("set", {{"convert.width", "wide"}}, "--width: wide");
  expect_refusal("set", {{"convert.method", "otsu"}}, "is no setting of the page");
  expect_refusal("set", {{"loading.velocity", "1 m/s"}}, "is no setting of the page");
  EXPECT_EQ(state()["version"], before["version"]);
  EXPECT_EQ(state()["settings"], before["settings"]);
  EXPECT_EQ(json::parse(answers_.parts.at("strokes")().body)["strokes"].size(), 1U);
}

TEST_F(Session, TakesSettingsAsTheCommandLineDoes) {
  EXPECT_EQ(order("set", {{"convert.width", "48 mm"}, {"convert.split_touching", "true"}}).status, 200);
  EXPECT_EQ(state()["settings"]["convert.width"], "48 mm");
  EXPECT_EQ(state()["settings"]["convert.split_touching"], "true");
  EXPECT_TRUE(state()["has_scale"]);
  EXPECT_EQ(order("set", {{"convert.split_touching", "false"}, {"convert.smooth", "4"}}).status, 200);
  const auto wanted = session_->wanted();
  std::vector<std::string> options;
  for (const app::Assignment& one : wanted.given) options.push_back(one.field + " " + one.written);
  EXPECT_THAT(options, testing::UnorderedElementsAre("--width 48 mm", "--smooth 4"));
  EXPECT_EQ(order("set", {{"convert.width", nullptr}}).status, 200);
  EXPECT_FALSE(state()["has_scale"]);
}

TEST_F(Session, WidthTakesThePlaceOfThePixelSize) {
  begin({app::given_as_option("convert.pixel_size", app::Kind::quantity, "--pixel-size", "0.1 mm")});
  EXPECT_EQ(order("set", {{"convert.width", "48 mm"}}).status, 200);
  ASSERT_EQ(session_->wanted().given.size(), 1U);
  EXPECT_EQ(session_->wanted().given[0].key, "convert.width");
}

TEST_F(Session, UndoesAndErases) {
  teach();
  const std::size_t count = json::parse(answers_.parts.at("strokes")().body)["strokes"].size();
  EXPECT_EQ(order("remove", {{"version", state()["version"]}, {"strokes", {0, 2}}}).status, 200);
  EXPECT_EQ(json::parse(answers_.parts.at("strokes")().body)["strokes"].size(), count - 2);
  EXPECT_EQ(order("undo").status, 200);
  EXPECT_EQ(json::parse(answers_.parts.at("strokes")().body)["strokes"].size(), count);
  EXPECT_TRUE(state()["can_redo"]);
}

TEST_F(Session, WishesReachTheProgramAndItsAnswerThePage) {
  EXPECT_EQ(session_->wait(milliseconds(1)), EditWish::none);
  (void)order("make");
  (void)order("make");
  EXPECT_TRUE(state()["is_making"]);
  EXPECT_EQ(session_->wait(milliseconds(1)), EditWish::make);
  EXPECT_EQ(session_->wait(milliseconds(1)), EditWish::none) << "once is enough";
  (void)session_->wanted();
  session_->failed("there is no scale");
  EXPECT_FALSE(state()["is_making"]);
  EXPECT_EQ(state()["fault"], "there is no scale");
  (void)order("make");
  EXPECT_EQ(session_->wait(milliseconds(1)), EditWish::make);
  (void)session_->wanted();
  app::Made made;
  made.command = "mesopix convert photo.png";
  made.segmentation.mask.labels = specimen::Raster<std::uint8_t>(2, 2, 2);
  made.segmentation.instances = specimen::Raster<std::int32_t>(2, 2, 0);
  session_->made(std::move(made));
  EXPECT_TRUE(sorted()["made"]["is_current"]);
  EXPECT_EQ(state()["found"]["rows"], 2);
  (void)order("add", {{"phase", "mortar"}, {"width", 5}, {"points", {{10, 10}}}});
  EXPECT_FALSE(state()["made"]["is_current"]);
  answers_.stop();
  EXPECT_EQ(session_->wait(milliseconds(1)), EditWish::finish);
}

}  // namespace edit_session_test
