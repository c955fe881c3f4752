#include "apps/study/study_outcome.hpp"

#include <gtest/gtest.h>

namespace study_outcome_test {

using app::study_text;

TEST(StudyLine, TellsCountFailuresAndTimeLeft) {
  EXPECT_EQ(study_text({100, 0, 0, 0}, 3), "0 of 100 members");
  EXPECT_EQ(study_text({100, 20, 10, 0}, 5), "30 of 100 members   35 s left");
  EXPECT_EQ(study_text({100, 0, 9, 1}, 60), "10 of 100 members   1 failed   9 min left");
}

}  // namespace study_outcome_test
