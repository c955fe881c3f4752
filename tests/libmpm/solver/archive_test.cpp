#include "libmpm/solver/archive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace archive_test {

using mpm::ArchiveReader;
using mpm::ArchiveWriter;

/// One of each.
struct State {
  std::int64_t step = -1;
  int column = -1;
  double time = -1;
  float speed = -1;
  bool over = false;
  std::array<double, 3> field{};
  std::vector<std::uint8_t> list;
  std::string name;
  friend bool operator==(const State&, const State&) = default;
};

template <class Archive, class Any>
void pass(Archive& archive, Any& state) {
  archive.whole(state.step, 0, 100);
  archive.whole(state.column, -1, 9);
  archive.finite(state.time);
  archive.finite(state.speed);
  archive.flag(state.over);
  archive.block(state.field);
  archive.list(state.list);
  archive.text(state.name);
}

const State sample{7, 9, 0.1, 2.5F, true, {-0.0, 5e-324, 1e300}, {1, 2, 3}, "mortar"};

std::string archived(const State& state) {
  ArchiveWriter writer;
  pass(writer, state);
  return writer.take();
}

TEST(Archive, GivesBackWhatWasWritten) {
  const std::string bytes = archived(sample);
  ArchiveReader reader(bytes);
  State state;
  pass(reader, state);
  reader.finish();
  EXPECT_TRUE(reader.ok()) << reader.fault();
  EXPECT_EQ(state, sample);
  EXPECT_TRUE(std::signbit(state.field[0]));
}

TEST(Archive, KeepsNumbersThatAreNoneInFields) {
  ArchiveWriter writer;
  writer.block(std::array{std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()});
  const std::string bytes = writer.take();
  std::array<float, 2> field{};
  ArchiveReader reader(bytes);
  reader.block(field);
  EXPECT_TRUE(reader.ok());
  EXPECT_TRUE(std::isnan(field[0]));
  EXPECT_TRUE(std::isinf(field[1]));
}

TEST(Archive, NotesWhereItIsCutShort) {
  const std::string bytes = archived(sample);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    State state;
    ArchiveReader reader(std::string_view(bytes).substr(0, length));
    pass(reader, state);
    EXPECT_EQ(reader.fault(), "too short") << length;
  }
}

TEST(Archive, NotesWhatIsBehindItsEnd) {
  const std::string bytes = archived(sample) + "x";
  State state;
  ArchiveReader reader(bytes);
  pass(reader, state);
  EXPECT_TRUE(reader.ok());
  reader.finish();
  EXPECT_EQ(reader.fault(), "bytes after its end");
}

TEST(Archive, NotesNumbersThatCannotBe) {
  const auto fault_of = [](State state) {
    const std::string bytes = archived(state);
    State read;
    ArchiveReader reader(bytes);
    pass(reader, read);
    return reader.fault();
  };
  State state = sample;
  for (const std::int64_t step : {std::int64_t{-1}, std::int64_t{101}, INT64_MIN, INT64_MAX}) {
    state.step = step;
    EXPECT_EQ(fault_of(state), "a number out of range") << step;
  }
  state = sample;
  state.column = 10;
  EXPECT_EQ(fault_of(state), "a number out of range");
  state = sample;
  state.time = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fault_of(state), "a value that is not a number");
  state = sample;
  state.speed = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(fault_of(state), "a value that is not a number");
}

// Else a damaged length would ask for all the memory there is.
TEST(Archive, TakesNoMemoryForWhatIsNotThere) {
  for (const std::uint64_t length : {std::uint64_t{4}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    ArchiveWriter writer;
    writer.raw(&length, 1);
    writer.raw("abc", 3);
    const std::string bytes = writer.take();
    std::vector<double> numbers{1.0};
    ArchiveReader first(bytes);
    first.list(numbers);
    EXPECT_EQ(first.fault(), "too short");
    EXPECT_EQ(numbers.capacity(), 1U);
    std::string text;
    ArchiveReader second(bytes);
    second.text(text);
    EXPECT_EQ(second.fault(), "too short");
    EXPECT_TRUE(text.empty());
  }
}

TEST(Archive, TakesNoFieldOfAnotherLength) {
  ArchiveWriter writer;
  writer.block(std::array{1.0, 2.0});
  const std::string bytes = writer.take();
  std::array<double, 1> field{7.0};
  ArchiveReader reader(bytes);
  reader.block(field);
  EXPECT_EQ(reader.fault(), "a field of another length");
  EXPECT_EQ(field[0], 7.0);
}

TEST(Archive, ReadsNothingBehindTheFirstFault) {
  const std::string bytes = archived(sample);
  State state;
  ArchiveReader reader(bytes);
  reader.fail("no such thing");
  reader.fail("another");
  pass(reader, state);
  EXPECT_EQ(state, State{});
  EXPECT_EQ(reader.fault(), "no such thing");
}

}  // namespace archive_test
