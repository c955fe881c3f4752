#include "apps/export/pixel_mesh.hpp"

#include <bit>
#include <cassert>

#include "apps/export/mesh_text.hpp"
#include "specimen/body/error.hpp"

namespace exchange {

const char* name_of(Edge edge) {
  static constexpr std::array names{"BOTTOM", "RIGHT", "TOP", "LEFT"};  // in the order of `edges`
  return names[static_cast<std::size_t>(edge)];
}

void DenseNumbers::add(bool taken) {
  const auto bit = static_cast<unsigned>(places_ % 64);
  if (bit == 0) {
    taken_.push_back(0);
    before_.push_back(count_);
  }
  if (taken) {
    taken_.back() |= std::uint64_t{1} << bit;
    ++count_;
  }
  ++places_;
}

std::int64_t DenseNumbers::of(std::int64_t place) const {
  assert(place >= 0 && place < places_);
  const auto word = static_cast<std::size_t>(place / 64);
  const std::uint64_t earlier = (std::uint64_t{1} << static_cast<unsigned>(place % 64)) - 1;
  return before_[word] + std::popcount(taken_[word] & earlier) + 1;
}

PixelMesh::PixelMesh(const specimen::LabelledMask& mask) : mask_(mask) {
  const std::vector<std::int64_t> counts = specimen::count_labels(mask);
  for (std::size_t label = 0; label < counts.size(); ++label)
    if (label != specimen::phase::void_ && counts[label] > 0)
      phases_.push_back({static_cast<std::uint8_t>(label), mask.phases[label], counts[label]});
  if (phases_.empty())
    throw specimen::Error("specimen", "is void throughout", "a mesh needs a pixel that is not");
  for (int row = 0; row < rows(); ++row)
    for (int col = 0; col < cols(); ++col) elements_.add(solid(row, col));
  for (int line = 0; line <= rows(); ++line)
    for (int col = 0; col <= cols(); ++col) nodes_.add(has({line, col}));
}

bool PixelMesh::has(MeshNode node) const {
  const auto [line, col] = node;
  return solid(line - 1, col - 1) || solid(line - 1, col) || solid(line, col - 1) || solid(line, col);
}

std::array<std::int64_t, 4> PixelMesh::corners(int row, int col) const {
  return {number({row + 1, col}), number({row + 1, col + 1}), number({row, col + 1}), number({row, col})};
}

void PixelMesh::for_each_node(const std::function<void(MeshNode)>& visit) const {
  for (int line = 0; line <= rows(); ++line)
    for (int col = 0; col <= cols(); ++col)
      if (has({line, col})) visit({line, col});
}

void PixelMesh::for_each_element(const MeshPhase& phase,
                                 const std::function<void(int row, int col)>& visit) const {
  for (int row = 0; row < rows(); ++row)
    for (int col = 0; col < cols(); ++col)
      if (mask_.labels(row, col) == phase.label) visit(row, col);
}

std::vector<std::array<std::int64_t, 2>> PixelMesh::sides(Edge edge) const {
  const bool level = edge == Edge::bottom || edge == Edge::top;
  const bool backwards = edge == Edge::top || edge == Edge::right;
  const int count = level ? cols() : rows();
  const auto first = static_cast<std::size_t>(edge);  // corner of a pixel at which its side begins
  std::vector<std::array<std::int64_t, 2>> all;
  for (int k = 0; k < count; ++k) {
    const int along = backwards ? count - 1 - k : k;
    const int row = level ? (edge == Edge::bottom ? rows() - 1 : 0) : along;
    const int col = level ? along : (edge == Edge::right ? cols() - 1 : 0);
    if (!solid(row, col)) continue;
    const std::array<std::int64_t, 4> corner = corners(row, col);
    all.push_back({corner[first], corner[(first + 1) % 4]});
  }
  return all;
}

std::vector<std::int64_t> PixelMesh::nodes_on(Edge edge) const {
  std::vector<std::int64_t> numbers;
  for (const auto& [begin, end] : sides(edge)) {
    if (numbers.empty() || numbers.back() != begin) numbers.push_back(begin);
    numbers.push_back(end);
  }
  return numbers;
}

std::vector<std::string> PixelMesh::x_texts() const {
  std::vector<std::string> texts;
  for (int col = 0; col <= cols(); ++col) texts.push_back(length_text(col * mask_.pixel_size));
  return texts;
}

std::vector<std::string> PixelMesh::y_texts() const {
  std::vector<std::string> texts;
  for (int line = 0; line <= rows(); ++line) texts.push_back(length_text((rows() - line) * mask_.pixel_size));
  return texts;
}

}  // namespace exchange
