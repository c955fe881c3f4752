#include "apps/settings/assignment.hpp"

#include <gtest/gtest.h>
#include <filesystem>
#include <new>

#include "apps/system/files.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"

namespace assignment_test {

using app::Exit;

app::Rejected refusal_of(const auto& exception, const app::Origins& origins = {}) {
  return app::refusal_of(std::make_exception_ptr(exception), app::located_by(origins));
}

TEST(Refusal, TellsKindsOfFaultsApart) {
  EXPECT_EQ(refusal_of(specimen::Error("generate.gap", "-1 m", "must be >= 0")).code, Exit::data);
  EXPECT_EQ(refusal_of(specimen::Error("a.h5", "no space", "", "", specimen::Fault::write)).code, Exit::io);
  EXPECT_EQ(refusal_of(mpm::Error("solver.cfl", "2", "must be <= 1")).code, Exit::data);
  EXPECT_EQ(refusal_of(mpm::FileError("a.h5", "no space", "")).code, Exit::io);
  EXPECT_EQ(refusal_of(std::filesystem::filesystem_error("stat", std::error_code())).code, Exit::io);
  EXPECT_EQ(refusal_of(std::bad_alloc()).code, Exit::data);
  EXPECT_EQ(refusal_of(app::Rejected(Exit::usage, app::complaint("-o", "x", "y"))).code, Exit::usage);
}

TEST(Refusal, OfABugSaysSo) {
  const app::Rejected found = refusal_of(std::logic_error("impossible"));
  EXPECT_EQ(found.code, Exit::internal);
  EXPECT_STREQ(found.what(), "internal error: impossible; please report it");
}

TEST(Refusal, NamesEveryFileThatIsMissing) {
  const app::Rejected found = refusal_of(NotWritten(
      {mpm::FileError("a.h5", "no space", "", "make room"), mpm::FileError("b.csv", "no space", "")}));
  EXPECT_EQ(found.code, Exit::io);
  EXPECT_STREQ(found.what(), "a.h5: no space; make room\nb.csv: no space");
}

TEST(Refusal, StandsWhereTheUserSetIt) {
  const app::Origins origins{{"solver.cfl", {"solver.cfl", {}, {"scene.toml", 3, 7}, "solver.cfl", "2"}}};
  EXPECT_STREQ(refusal_of(mpm::Error("solver.cfl", "2", "must be <= 1"), origins).what(),
               "scene.toml:3:7: solver.cfl: 2; must be <= 1");
}

}  // namespace assignment_test
