#include "apps/live/live_view.hpp"

#include <gtest/gtest.h>
#include <httplib.h>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/report/report.hpp"
#include "tests/apps/fake_run.hpp"

namespace live_view_test {

/// The view of a run of 40 pixels a side, and a reader of it.
class View : public testing::Test {
 protected:
  [[nodiscard]] std::string root() const { return address_.substr(address_.find('/', 7)); }
  [[nodiscard]] httplib::Client client() const {
    return httplib::Client(address_.substr(0, address_.find('/', 7)));
  }

  /// The solver comes to a row.
  bool come_to(std::size_t rows) {
    const mpm::Result whole = run_.result;
    const mpm::HistoryRow row = whole.history.at(rows - 1);
    return view_.look({row, 0.25, 3, [&] {
                         ++copies_;
                         mpm::Result part = whole;
                         part.history.resize(rows);
                         return part;
                       }});
  }
  /// What a reader gets who has `have`; null = nothing new.
  nlohmann::json news(std::int64_t have) {
    const auto answer = client().Get(root() + "now?have=" + std::to_string(have));
    return answer->status == 200 ? nlohmann::json::parse(answer->body) : nlohmann::json(nullptr);
  }

  FakeRun run_ = tension_run(40);
  app::LiveView view_{{run_.specimen, run_.scene, run_.scene_toml, "hash", "A <title>", {"a note"}}, 0};
  std::string address_ = view_.address();
  int copies_ = 0;
};

TEST_F(View, CostsTheSolverNothingWhileNobodyLooks) {
  for (std::size_t rows = 1; rows < 10; ++rows) EXPECT_TRUE(come_to(rows));
  EXPECT_EQ(copies_, 0);
}

TEST_F(View, ShowsTheNextRowToWhoeverAsks) {
  EXPECT_TRUE(news(0).is_null());
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(come_to(30));
  EXPECT_TRUE(come_to(31));
  EXPECT_EQ(copies_, 1) << "one question, one copy";
  const nlohmann::json update = news(0);
  EXPECT_EQ(update.at("number"), 1);
  EXPECT_EQ(update.at("fraction"), 0.25);
  EXPECT_TRUE(update.at("goes_on"));
  EXPECT_TRUE(update.at("csv").is_null());
  EXPECT_EQ(update.at("charts").at("stress").at("series").at(0).at("x").size(), 30U);
  EXPECT_TRUE(news(1).is_null());
  const bool soon = std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(500);
  EXPECT_TRUE(come_to(32));
  if (soon) {
    EXPECT_EQ(copies_, 1) << "too soon for another look";
  }
}

TEST_F(View, GivesThePageOnceThereIsARow) {
  std::optional<std::string> page;
  std::thread reader([&] { page = client().Get(root())->body; });
  for (int i = 0; i < 2000 && copies_ == 0; ++i) {
    EXPECT_TRUE(come_to(30));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  reader.join();
  EXPECT_NE(page->find("A &lt;title&gt;"), std::string::npos);
  EXPECT_NE(page->find("data-number=\"1\""), std::string::npos);
  EXPECT_NE(page->find("connect-src 'self'"), std::string::npos);
}

TEST_F(View, StopsTheRunWhenTheReaderWants) {
  EXPECT_TRUE(come_to(10));
  client().Post(root() + "stop");
  EXPECT_FALSE(come_to(11));
}

TEST_F(View, TellsTheEndToThoseWhoStillWatch) {
  EXPECT_TRUE(news(0).is_null());
  std::thread end([&] { view_.finish(run_.result, "The run has ended."); });
  nlohmann::json update;
  while (update.is_null()) update = news(0);
  end.join();
  EXPECT_FALSE(update.at("goes_on"));
  EXPECT_EQ(update.at("words"), "The run has ended.");
  EXPECT_TRUE(update.at("csv").is_string());
  EXPECT_NE(update.at("parts").at("solution").get<std::string>().find("Ended because"), std::string::npos);
}

TEST_F(View, WaitsForNobodyAtTheEnd) {
  const auto begin = std::chrono::steady_clock::now();
  view_.finish(run_.result, "The run has ended.");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2)) << "its patience with readers";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// On its way: half of its rows, nothing failed yet.
FakeRun beginning() {
  FakeRun run = tension_run(40);
  run.result.history.resize(5);
  run.result.failure_mode.setZero();
  run.result.failure_strain.setConstant(std::numeric_limits<float>::quiet_NaN());
  return run;
}

RunRecord going_on(const FakeRun& run) {
  RunRecord record = run.record();
  record.goes_on = true;
  return record;
}

TEST(Watching, PageIsTheReportWithABar) {
  const FakeRun run = beginning();
  const std::string page = output::watching_html(going_on(run), {4, 0.4, "42 % <b>"});
  EXPECT_TRUE(holds(page, "data-number=\"4\""));
  EXPECT_TRUE(holds(page, "42 % &lt;b&gt;"));
  EXPECT_TRUE(holds(page, "id=\"film\""));
  EXPECT_FALSE(holds(page, "Ended because"));
  EXPECT_TRUE(holds(page, "Stress now"));
  EXPECT_FALSE(holds(page, "Stress at the end"));
  for (const char* part : {"facts", "failures", "solution"})
    EXPECT_TRUE(holds(page, "id=\"part-" + std::string(part) + "\"")) << part;
  EXPECT_TRUE(holds(page, "id=\"chart-failure-strain\"")) << "there may be failures later on";
}

TEST(Watching, OnlyThePageOfARunThatGoesOnAsksAServer) {
  const FakeRun run = beginning();
  EXPECT_TRUE(holds(output::watching_html(going_on(run), {}), "connect-src 'self'"));
  EXPECT_TRUE(holds(output::watching_html(going_on(run), {}), "fetch("));
  EXPECT_FALSE(holds(output::report_html(run.record()), "connect-src"));
  EXPECT_FALSE(holds(output::report_html(run.record()), "fetch("));
}

TEST(Watching, UpdateHoldsWhatChanges) {
  const FakeRun run = tension_run(40);
  const std::string text = output::watching_update(going_on(run), {9, 0.5, "</script>"});
  EXPECT_FALSE(holds(text, "<"));
  const nlohmann::json update = nlohmann::json::parse(text);
  EXPECT_EQ(update.at("number"), 9);
  EXPECT_EQ(update.at("words"), "</script>");
  EXPECT_TRUE(update.at("goes_on"));
  EXPECT_EQ(update.at("film").at("end_strain"), run.result.history.back().strain);
  EXPECT_FALSE(update.at("film").contains("labels")) << "the specimen stays the same";
  EXPECT_FALSE(update.at("charts").contains("sieve"));
  EXPECT_EQ(update.at("charts").at("energy").at("series").at(0).at("x").size(), run.result.history.size());
  EXPECT_TRUE(holds(update.at("parts").at("failures"), "Mortar"));
}

TEST(Watching, LastUpdateBringsTheTable) {
  const FakeRun run = tension_run(40);
  const nlohmann::json update = nlohmann::json::parse(output::watching_update(run.record(), {}));
  EXPECT_FALSE(update.at("goes_on"));
  EXPECT_TRUE(update.at("csv").is_string());
}

TEST(Watching, ThereMayBeNoFilmYet) {
  FakeRun run = beginning();
  run.result.history.resize(1);
  run.result.history.front().strain = 0;
  EXPECT_TRUE(nlohmann::json::parse(output::watching_update(going_on(run), {})).at("film").is_null());
}

}  // namespace live_view_test
