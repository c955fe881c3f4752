#include "apps/drawing/drawing_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vector_file_test {

using output::vector_file;
using output::VectorFormat;
using testing::HasSubstr;
using testing::StartsWith;

output::Drawing small_drawing() {
  specimen::Raster<specimen::Rgb> picture(2, 2);
  output::Drawing drawing{100, 60, "Title", {}};
  drawing.shapes.push_back(output::Pixels{{0, 0}, 40, 40, picture});
  drawing.shapes.push_back(output::Block{{50, 0}, 10, 10, {255, 0, 0}, true});
  drawing.shapes.push_back(output::Words{{50, 40}, "words"});
  return drawing;
}

TEST(VectorFile, IsOfItsFormatAndSize) {
  const std::string svg = vector_file(small_drawing(), VectorFormat::svg, 10);
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_THAT(svg, HasSubstr("width=\"90pt\" height=\"60pt\""));  // 3/4 of 100 + 20 by 60 + 20
  const std::string pdf = vector_file(small_drawing(), VectorFormat::pdf, 10);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [ 0 0 90 60 ]"));
}

TEST(VectorFile, DoesNotTellTheTimeOfDay) {
  const std::string pdf = vector_file(small_drawing(), VectorFormat::pdf, 0);
  EXPECT_EQ(pdf, vector_file(small_drawing(), VectorFormat::pdf, 0));
  EXPECT_THAT(pdf, testing::Not(HasSubstr("CreationDate")));
}

}  // namespace vector_file_test
