#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/file/specimen_file.hpp"
#include "tests/apps/program_in_folder.hpp"
#include "tests/apps/small_specimen.hpp"

namespace inspect_command_test {

using app::Exit;
using testing::HasSubstr;

class InspectCommand : public test::ProgramInFolder {
 protected:
  InspectCommand() : ProgramInFolder("inspect") {}
};

TEST_F(InspectCommand, WarnsOfASpecimenThatIsNoConcrete) {
  specimen::Specimen specimen = test::small_specimen();
  specimen.provenance.source = "generated";
  specimen::write_specimen("made.h5", specimen);
  EXPECT_EQ(run({"made.h5"}), Exit::ok);
  EXPECT_EQ(err_.str(), "");
  specimen.provenance.source = "photo.png";
  specimen::write_specimen("photo.h5", specimen);
  EXPECT_EQ(run({"photo.h5"}), Exit::ok);
  EXPECT_THAT(err_.str(), HasSubstr("warning: there is no aggregate"));
  EXPECT_THAT(out_.str(), HasSubstr("specimen 12 mm x 12 mm"));
}

}  // namespace inspect_command_test
