/// Grey values of a picture, in the smallest numbers that hold all of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// Numbers that are read as double, and stored as they came: bytes, 16 bits, float or double.
class Numbers {
 public:
  /// One of the numbers; a new value that does not fit makes all of them double.
  class Reference {
   public:
    Reference(Numbers& all, std::size_t i) : all_(all), i_(i) {}
    Reference& operator=(double value) {
      all_.set(i_, value);
      return *this;
    }
    operator double() const { return std::as_const(all_)[i_]; }  // NOLINT(google-explicit-constructor)

   private:
    Numbers& all_;
    std::size_t i_;
  };

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = double;
    using difference_type = std::ptrdiff_t;
    using pointer = const double*;
    using reference = double;
    Iterator(const Numbers& all, std::size_t i) : all_(&all), i_(i) {}
    double operator*() const { return (*all_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    Iterator operator++(int) { return {*all_, i_++}; }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.i_ == b.i_; }

   private:
    const Numbers* all_;
    std::size_t i_;
  };

  Numbers() = default;
  template <class T>
  Numbers(std::vector<T> values) : stored_(std::move(values)) {}  // NOLINT(google-explicit-constructor)

  /// The result of a function of the vector that holds the numbers: the fast way over all of them.
  template <class Function>
  decltype(auto) visit(const Function& function) const {
    return std::visit(function, stored_);
  }

  [[nodiscard]] std::size_t size() const {
    return visit([](const auto& values) { return values.size(); });
  }
  [[nodiscard]] bool empty() const { return size() == 0; }
  double operator[](std::size_t i) const {
    return visit([i](const auto& values) { return static_cast<double>(values[i]); });
  }
  Reference operator[](std::size_t i) { return {*this, i}; }
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

  /// Put a number that any of the types can hold, or widen all to double.
  void set(std::size_t i, double value) {
    const bool stored = std::visit(
        [&](auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_integral_v<T>)
            if (!(value >= 0 && value <= static_cast<double>(T(-1)))) return false;
          values[i] = static_cast<T>(value);
          return static_cast<double>(values[i]) == value || value != value;
        },
        stored_);
    if (stored) return;
    std::vector<double> wide = doubles();
    wide[i] = value;
    stored_ = std::move(wide);
  }

  [[nodiscard]] std::vector<double> doubles() const {
    return visit([](const auto& values) { return std::vector<double>(values.begin(), values.end()); });
  }

  friend bool operator==(const Numbers& a, const Numbers& b) { return a.doubles() == b.doubles(); }

 private:
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>, std::vector<double>>
      stored_;
};

/// Grey values per pixel, shape (rows, cols), row-major, top row first.
struct GreyLevels {
  int rows = 0;  ///< number of pixel rows [-]
  int cols = 0;  ///< number of pixel columns [-]
  Numbers data;  ///< rows * cols of them

  GreyLevels() = default;
  template <class T>
  GreyLevels(Raster<T> raster)  // NOLINT(google-explicit-constructor): a raster of any of its types is one
      : rows(raster.rows), cols(raster.cols), data(std::move(raster.data)) {}

  [[nodiscard]] std::size_t size() const { return data.size(); }
  [[nodiscard]] bool empty() const { return data.empty(); }
  double operator()(int row, int col) const { return data[place(row, col)]; }
  Numbers::Reference operator()(int row, int col) { return data[place(row, col)]; }

  /// The same in another form: the result of a function from Raster<T> to Raster<T>, whatever T is.
  template <class Function>
  [[nodiscard]] GreyLevels with(const Function& function) const {
    return data.visit([&](const auto& values) {
      using T = typename std::decay_t<decltype(values)>::value_type;
      Raster<T> raster;
      raster.rows = rows;
      raster.cols = cols;
      raster.data = values;
      return GreyLevels(function(raster));
    });
  }

  [[nodiscard]] Raster<double> doubles() const {
    Raster<double> all;
    all.rows = rows;
    all.cols = cols;
    all.data = data.doubles();
    return all;
  }

  friend bool operator==(const GreyLevels&, const GreyLevels&) = default;

 private:
  [[nodiscard]] std::size_t place(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols) + static_cast<std::size_t>(col);
  }
};

}  // namespace specimen
