#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/program_in_folder.hpp"

namespace doctor_command_test {

using app::Exit;

class DoctorCommand : public test::ProgramInFolder {
 protected:
  DoctorCommand() : ProgramInFolder("doctor") {}
};

TEST_F(DoctorCommand, FindsTheNumbersRightAndLeavesNothing) {
  ASSERT_EQ(run({"--json"}), Exit::ok) << out_.str();
  const auto json = nlohmann::json::parse(out_.str());
  EXPECT_EQ(json["ready"], true);
  EXPECT_EQ(json["figures"]["same_on_threads"], true);
  EXPECT_GT(json["figures"]["point_updates_per_second"].get<double>(), 1e5);
  EXPECT_GT(json["figures"]["share_of_peak"].get<double>(), 0);
  EXPECT_LT(json["figures"]["share_of_peak"].get<double>(), 1);
  for (const char* library : {"HDF5", "OpenCV", "libpng", "libtiff"})
    EXPECT_THAT(json["figures"]["libraries"][library].get<std::string>(),
                testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+.*"))
        << library;
  EXPECT_TRUE(std::filesystem::is_empty("."));
}

}  // namespace doctor_command_test
