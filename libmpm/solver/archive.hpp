/// Serialisation of the state of a run: numbers, texts and fields in one string of bytes, little-endian.
///
/// Writer and reader have the same member functions, so that one function serves both:
///   template <class Archive, class State> void pass(Archive& archive, State& state) {
///     archive.whole(state.step, 0, last);
///     archive.block(state.displacement);
///   }
/// A reader checks every value. At the first impossible one it records a fault and stops reading; the
/// remaining variables keep their values. No call throws, and none allocates more memory than the bytes need.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace mpm {

static_assert(std::endian::native == std::endian::little, "an archive holds its numbers little end first");

class ArchiveWriter {
 public:
  static constexpr bool reads = false;

  /// A finite number.
  template <class Real>
  void finite(const Real& value) {
    raw(&value, 1);
  }
  /// An integer from `low` to `high`, stored in 64 bits.
  template <class Whole>
  void whole(const Whole& value, std::int64_t /*low*/, std::int64_t /*high*/) {
    const auto number = static_cast<std::int64_t>(value);
    raw(&number, 1);
  }
  void flag(const bool& value) { whole(static_cast<int>(value), 0, 1); }
  /// Contiguous values of a length that the reader knows.
  template <class Range>
  void block(const Range& values) {
    list_of(values.data(), static_cast<std::size_t>(values.size()));
  }
  /// Contiguous values of any length.
  template <class T, class Allocator>
  void list(const std::vector<T, Allocator>& values) {
    list_of(values.data(), values.size());
  }
  void text(const std::string& value) { list_of(value.data(), value.size()); }

  /// Values without their number.
  template <class T>
  void raw(const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (count > 0) bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }

  /// The bytes written, moved out.
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  template <class T>
  void list_of(const T* values, std::size_t count) {
    whole(count, 0, 0);
    raw(values, count);
  }

  std::string bytes_;
};

class ArchiveReader {
 public:
  static constexpr bool reads = true;

  /// The bytes must outlive the reader.
  explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Real>
  void finite(Real& value) {
    static_assert(std::is_floating_point_v<Real>);
    Real number = 0;
    if (!raw(&number, 1)) return;
    if (!std::isfinite(number)) return fail("a value that is not a number");
    value = number;
  }
  template <class Whole>
  void whole(Whole& value, std::int64_t low, std::int64_t high) {
    std::int64_t number = 0;
    if (!raw(&number, 1)) return;
    if (number < low || number > high) return fail("a number out of range");
    value = static_cast<Whole>(number);
  }
  void flag(bool& value) {
    int number = value ? 1 : 0;
    whole(number, 0, 1);
    value = number != 0;
  }
  /// Into `values`, whose length the archive must have.
  template <class Range>
  void block(Range& values) {
    const auto length = static_cast<std::size_t>(values.size());
    if (count_of(sizeof(*values.data())) != length) return fail("a field of another length");
    (void)raw(values.data(), length);
  }
  template <class T, class Allocator>
  void list(std::vector<T, Allocator>& values) {
    const std::size_t length = count_of(sizeof(T));
    if (!ok()) return;
    values.resize(length);
    (void)raw(values.data(), length);
  }
  void text(std::string& value) {
    const std::size_t length = count_of(1);
    if (!ok()) return;
    value.resize(length);
    (void)raw(value.data(), length);
  }

  /// @return whether the bytes were there.
  template <class T>
  bool raw(T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!holds(count, sizeof(T))) fail("too short");
    if (!ok()) return false;
    if (count > 0) std::memcpy(values, bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
    return true;
  }
  /// Whether so many values are left.
  [[nodiscard]] bool holds(std::size_t count, std::size_t size) const {
    return count <= bytes_.size() / size;
  }

  /// Records a fault; only the first is kept.
  void fail(std::string_view what) {
    if (ok()) fault_ = what;
  }
  /// Records a fault if bytes are left.
  void finish() {
    if (!bytes_.empty()) fail("bytes after its end");
  }
  [[nodiscard]] bool ok() const { return fault_.empty(); }
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

 private:
  /// Number of values that follow; they are all there.
  [[nodiscard]] std::size_t count_of(std::size_t size) {
    std::uint64_t count = 0;
    if (!raw(&count, 1)) return 0;
    if (holds(count, size)) return count;
    fail("too short");
    return 0;
  }

  std::string_view bytes_;
  std::string fault_;
};

}  // namespace mpm
