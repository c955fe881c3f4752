#include "apps/twin/twinning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/file/specimen_file.hpp"
#include "tests/apps/small_twins.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace app {
namespace twinning_test {

TEST(Twinning, NamesItsFilesInOrder) {
  EXPECT_EQ(twin_file(1), "twin_001.h5");
  EXPECT_EQ(twin_file(1000), "twin_1000.h5");
}

TEST(Twinning, WritesSpecimensThatSayWhereTheyCameFrom) {
  const test::TemporaryFolder folder;
  const TwinTask task = test::small_task();
  std::size_t told = 0;
  const auto twins = make_twins(
      task, folder / "", [] { return false; }, [&](std::size_t done) { told = done; });
  ASSERT_EQ(twins.size(), 2u);
  EXPECT_EQ(told, 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(twins[i].seed, 5 + i);
    const specimen::Specimen read = specimen::read_specimen(folder / twins[i].file);
    EXPECT_EQ(read.provenance.source, "twin of cut.png");
    EXPECT_EQ(read.provenance.sha256, std::string(64, 'a'));
    EXPECT_EQ(read.provenance.seed, 5 + i);
    EXPECT_THAT(read.provenance.options, testing::StartsWith("# options of the original\n"));
    EXPECT_THAT(read.provenance.options,
                testing::HasSubstr("seed " + std::to_string(5 + i) + ", 40 mm x 40 mm"));
    EXPECT_EQ(specimen::describe(read).s2.radial, twins[i].descriptors.s2.radial);
    EXPECT_FALSE(read.rings.empty());
    EXPECT_EQ(twins[i].picture.rows, 80);
  }
}

TEST(Twinning, KeepsWhatWasMadeWhenStopped) {
  const test::TemporaryFolder folder;
  TwinTask task = test::small_task();
  task.count = 200;
  int asked = 0;
  const auto twins = make_twins(
      task, folder / "", [&] { return ++asked > 3; }, [](std::size_t) {});
  ASSERT_GE(twins.size(), 1u);
  ASSERT_LT(twins.size(), 200u);
  for (std::size_t i = 0; i < twins.size(); ++i) {
    EXPECT_EQ(twins[i].file, twin_file(static_cast<int>(i) + 1));
    EXPECT_FALSE(twins[i].descriptors.s2.radial.empty());
  }
}

}  // namespace twinning_test
}  // namespace app
