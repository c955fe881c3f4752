#include "apps/study/study_run.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "specimen/body/error.hpp"

namespace study_specimens_test {

using namespace app;

Settings of_seed(std::uint64_t seed) {
  Settings settings;
  settings.packing.width = settings.packing.height = 0.02;
  settings.pixel_size = 1e-3;
  settings.grading.d_min = 4e-3;
  settings.grading.d_max = 8e-3;
  settings.packing.fraction = 0.3;
  settings.packing.seed = seed;
  return settings;
}

TEST(StudySpecimens, AreSharedByAllWhoNeedTheSame) {
  SpecimenStore store(2);
  Settings other_strengths = of_seed(1);
  other_strengths.scene.damage.seed = 9;
  const auto first = store.of(of_seed(1));
  EXPECT_EQ(store.of(other_strengths), first);
  EXPECT_NE(store.of(of_seed(2)), first);
  other_strengths.scene.points_per_cell = 3;  // it is cut to whole cells
  EXPECT_EQ(store.of(other_strengths)->mask.labels.rows, 18);
}

TEST(StudySpecimens, NoMoreAreKeptThanAskedFor) {
  SpecimenStore store(2);
  const std::weak_ptr<const specimen::Specimen> first = store.of(of_seed(1)), second = store.of(of_seed(2));
  (void)store.of(of_seed(1));
  (void)store.of(of_seed(3));
  EXPECT_FALSE(first.expired()) << "it was asked for last";
  EXPECT_TRUE(second.expired());
}

TEST(StudySpecimens, AreMadeOnceByThreadsThatAskAtOnce) {
  SpecimenStore store(2);
  std::vector<std::shared_ptr<const specimen::Specimen>> got(8);
  {
    std::vector<std::jthread> threads;
    for (auto& one : got) threads.emplace_back([&] { one = store.of(of_seed(1)); });
  }
  for (const auto& one : got) EXPECT_EQ(one, got[0]);
}

TEST(StudySpecimens, AllHearWhyOneCannotBeMade) {
  SpecimenStore store(2);
  Settings full = of_seed(1);
  full.packing.fraction = 0.89;
  EXPECT_THROW((void)store.of(full), specimen::Error);
  EXPECT_THROW((void)store.of(full), specimen::Error);
}

}  // namespace study_specimens_test
