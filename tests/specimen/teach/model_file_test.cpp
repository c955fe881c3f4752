#include "specimen/teach/model_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"
#include "specimen/body/files.hpp"
#include "tests/specimen/scratch.hpp"

namespace model_file_test {

using specimen::TaughtModel;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TaughtModel small_model() {
  specimen::Lessons lessons;
  lessons.features = specimen::PixelFeatures::count_of(3);
  specimen::Random random(1);
  for (int i = 0; i < 60; ++i) {
    for (int f = 0; f < lessons.features; ++f)
      lessons.values.push_back(static_cast<float>(random.uniform(-1, 1)) + (f % 2 == i % 2 ? 1.0F : 0.0F));
    lessons.classes.push_back(static_cast<std::uint8_t>(i % 2));
    lessons.strokes.push_back(i % 6);
  }
  TaughtModel model;
  model.phases = {"aggregate", "mortar"};
  model.scales = 3;
  model.factor = 2;
  model.pixel_size = 1.0583e-5;
  model.evens_light = true;
  model.forest = specimen::grow_forest(lessons, 2, {.trees = 5}, 1).forest;
  return model;
}

std::string complaint_of(const std::string& bytes) {
  try {
    (void)specimen::decode_model(bytes, "cut.mesomodel");
  } catch (const specimen::Error& error) {
    return error.what();
  }
  return "no complaint";
}

/// The bytes with one text in place of another, and the digest that belongs to them.
std::string changed(std::string bytes, const std::string& what, const std::string& into) {
  bytes.resize(bytes.size() - 64);
  bytes.replace(bytes.find(what), what.size(), into);
  return bytes + specimen::sha256_of_text(bytes);
}

TEST(ModelFile, ComesBackAsItWas) {
  const TaughtModel model = small_model();
  const std::string bytes = specimen::encode_model(model);
  EXPECT_THAT(bytes, StartsWith("mesopix model\nversion = 1\nfeatures = pyramid 1\nscales = 3\n"));
  EXPECT_EQ(specimen::decode_model(bytes, "m"), model);
  const specimen_test::Scratch scratch;
  EXPECT_EQ(specimen::read_model(scratch.write("m.mesomodel", bytes)), model);
}

TEST(ModelFile, OtherFeaturesAndVersionsAreRefusedWithTheCure) {
  const std::string bytes = specimen::encode_model(small_model());
  EXPECT_EQ(complaint_of(changed(bytes, "pyramid 1", "pyramid 2")),
            "cut.mesomodel: was taught with the features pyramid 2, 3 scales; this program has the features "
            "pyramid 1, "
            "at most 7 scales; teach it anew from the strokes: mesopix convert PICTURE --strokes STROKES "
            "--save-model "
            "MODEL");
  EXPECT_THAT(complaint_of(changed(bytes, "scales = 3", "scales = 9")), HasSubstr("pyramid 1, 9 scales"));
  EXPECT_THAT(complaint_of(changed(bytes, "version = 1", "version = 2")),
              HasSubstr("is a model of version 2"));
}

TEST(ModelFile, OtherFilesAndDamagedOnesAreRefused) {
  const std::string bytes = specimen::encode_model(small_model());
  EXPECT_THAT(complaint_of("\x89PNG"), HasSubstr("is no model of mesopix"));
  EXPECT_THAT(complaint_of(""), HasSubstr("is no model of mesopix"));
  std::string flipped = bytes;
  flipped[bytes.size() / 2] ^= 1;
  EXPECT_THAT(complaint_of(flipped), HasSubstr("is damaged: its digest does not fit"));
  for (std::size_t length = 0; length < bytes.size(); length += 97)
    EXPECT_NE(complaint_of(bytes.substr(0, length)), "no complaint") << length;
  EXPECT_THAT(complaint_of(changed(bytes, "scales = 3", "scales = x")), HasSubstr("is damaged: scales = x"));
  EXPECT_THAT(complaint_of(changed(bytes, "trees = 5", "trees = 9999")),
              HasSubstr("is damaged: it ends too soon"));
  EXPECT_THAT(complaint_of(changed(bytes, "phase = mortar\n", "")), HasSubstr("it names no two phases"));
}

TEST(ModelFile, WalksThatWouldNotEndAreRefused) {
  TaughtModel model = small_model();
  for (specimen::TreeNode& node : model.forest.nodes)
    if (node.leaf < 0) node.next = 0;
  EXPECT_THAT(complaint_of(specimen::encode_model(model)), HasSubstr("a node that leads back"));
  model = small_model();
  model.forest.nodes.back().leaf = 1'000'000;
  EXPECT_THAT(complaint_of(specimen::encode_model(model)), HasSubstr("a leaf without shares"));
  model = small_model();
  model.forest.nodes.front().feature = 4000;
  EXPECT_THAT(complaint_of(specimen::encode_model(model)), HasSubstr("a node without a feature"));
  model = small_model();
  model.forest.roots.front() = -3;
  EXPECT_THAT(complaint_of(specimen::encode_model(model)), HasSubstr("a tree without a root"));
}

TEST(ModelFile, WhatIsNoFileIsNotOpened) {
  try {
    (void)specimen::read_model("/dev/zero");
    FAIL() << "was read";
  } catch (const specimen::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("is not a regular file"));
  }
}

TEST(ModelFile, MissingFileIsNamed) {
  EXPECT_THROW((void)specimen::read_model("/nowhere/m.mesomodel"), specimen::Error);
}

}  // namespace model_file_test
