#include "specimen/teach/forest.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "specimen/body/raster.hpp"
#include "specimen/teach/parallel.hpp"

namespace specimen {
namespace {

constexpr int ranks = 256;
constexpr float unanimous = 0.95F;  ///< share of a class in the first quarter of the trees that ends the vote

/// Features as ranks, which are parted much faster than numbers: 256 steps between the values that occur.
struct RankedLessons {
  std::vector<std::uint8_t> rank;  ///< shape (features, pixels)
  std::vector<float> step;         ///< value that the last of a rank has, shape (features, ranks)
};

RankedLessons rank_of_lessons(const Lessons& lessons, int threads) {
  const std::size_t n = lessons.pixels(), features = static_cast<std::size_t>(lessons.features);
  RankedLessons ranked{std::vector<std::uint8_t>(features * n), std::vector<float>(features * ranks)};
  share_out(lessons.features, threads, [&](int feature) {
    const auto f = static_cast<std::size_t>(feature);
    std::vector<float> sorted(n);
    for (std::size_t i = 0; i < n; ++i) sorted[i] = lessons.values[i * features + f];
    std::sort(sorted.begin(), sorted.end());
    float* step = ranked.step.data() + f * ranks;
    for (std::size_t k = 0; k < ranks; ++k) step[k] = sorted[((k + 1) * n + ranks - 1) / ranks - 1];
    for (std::size_t i = 0; i < n; ++i)
      ranked.rank[f * n + i] = static_cast<std::uint8_t>(
          std::lower_bound(step, step + ranks - 1, lessons.values[i * features + f]) - step);
  });
  return ranked;
}

/// Draws a whole number below `count`.
std::size_t draw_below(Random& random, std::size_t count) {
  return std::min(count - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
}

/// The lessons of a stroke.
struct Bundle {
  int of_class = 0;
  std::int32_t stroke = 0;
  std::vector<std::int32_t> lessons;
};

std::vector<std::vector<Bundle>> bundles_of(const Lessons& lessons, int classes) {
  const std::int32_t strokes = 1 + *std::max_element(lessons.strokes.begin(), lessons.strokes.end());
  std::vector<Bundle> by_stroke(static_cast<std::size_t>(strokes));
  for (std::size_t i = 0; i < lessons.pixels(); ++i) {
    Bundle& bundle = by_stroke[static_cast<std::size_t>(lessons.strokes[i])];
    bundle.of_class = lessons.classes[i];
    bundle.stroke = lessons.strokes[i];
    bundle.lessons.push_back(static_cast<std::int32_t>(i));
  }
  std::vector<std::vector<Bundle>> by_class(static_cast<std::size_t>(classes));
  for (Bundle& bundle : by_stroke)
    if (!bundle.lessons.empty())
      by_class[static_cast<std::size_t>(bundle.of_class)].push_back(std::move(bundle));
  return by_class;
}

/// A tree that grows.
class Tree {
 public:
  Tree(const Lessons& lessons, const RankedLessons& ranked, int classes, const ForestOptions& options,
       std::uint64_t seed)
      : lessons_(lessons),
        ranked_(ranked),
        classes_(static_cast<std::size_t>(classes)),
        options_(options),
        random_(seed) {}

  void grow(const std::vector<std::vector<Bundle>>& by_class) {
    draw_lessons(by_class);
    nodes.emplace_back();
    tried_.resize(static_cast<std::size_t>(lessons_.features));
    std::iota(tried_.begin(), tried_.end(), 0);
    counts_.resize(ranks * classes_);
    grow_node(0, 0, drawn_.size(), 0);
    tried_ = {};  // a hundred of them wait to be put together
    counts_ = {};
    drawn_ = {};
  }

  std::vector<TreeNode> nodes;
  std::vector<float> shares;
  std::set<std::int32_t> seen;  ///< strokes

 private:
  void draw_lessons(const std::vector<std::vector<Bundle>>& by_class) {
    for (const std::vector<Bundle>& bundles : by_class) {
      std::vector<const Bundle*> chosen;
      std::size_t pixels = 0;
      for (std::size_t i = 0; i < bundles.size(); ++i) {
        chosen.push_back(&bundles[draw_below(random_, bundles.size())]);
        pixels += chosen.back()->lessons.size();
        seen.insert(chosen.back()->stroke);
      }
      for (int i = 0; i < options_.lessons; ++i) {
        std::size_t at = draw_below(random_, pixels), which = 0;
        while (at >= chosen[which]->lessons.size()) at -= chosen[which++]->lessons.size();
        drawn_.push_back(chosen[which]->lessons[at]);
      }
    }
  }

  struct Cut {
    double impurity = std::numeric_limits<double>::infinity();  ///< Gini's, times the number of lessons
    int feature = -1, rank = 0;
  };

  /// Gini's impurity of counts times their sum.
  static double impurity(const double* counts, std::size_t classes, double sum) {
    double squares = 0;
    for (std::size_t k = 0; k < classes; ++k) squares += counts[k] * counts[k];
    return sum > 0 ? sum - squares / sum : 0;
  }

  void try_feature(int feature, std::size_t begin, std::size_t end, const std::vector<double>& all,
                   Cut& best) {
    std::fill(counts_.begin(), counts_.end(), 0);
    const std::uint8_t* rank = ranked_.rank.data() + static_cast<std::size_t>(feature) * lessons_.pixels();
    for (std::size_t i = begin; i < end; ++i) {
      const auto lesson = static_cast<std::size_t>(drawn_[i]);
      ++counts_[rank[lesson] * classes_ + lessons_.classes[lesson]];
    }
    std::array<double, 256> left{}, right{};
    std::copy(all.begin(), all.end(), right.begin());
    double sum_left = 0, sum_right = static_cast<double>(end - begin);
    for (std::size_t k = 0; k + 1 < ranks; ++k) {
      double here = 0;
      for (std::size_t c = 0; c < classes_; ++c) {
        const double count = counts_[k * classes_ + c];
        left[c] += count;
        right[c] -= count;
        here += count;
      }
      if (here == 0) continue;
      sum_left += here;
      sum_right -= here;
      if (sum_right < options_.least_leaf) break;
      if (sum_left < options_.least_leaf) continue;
      const double sum =
          impurity(left.data(), classes_, sum_left) + impurity(right.data(), classes_, sum_right);
      if (sum < best.impurity) best = {sum, feature, static_cast<int>(k)};
    }
  }

  /// The best cut by two features, drawn at random; by further ones where these do not part the lessons.
  Cut best_cut(std::size_t begin, std::size_t end, const std::vector<double>& all) {
    constexpr std::size_t fewest = 2;
    Cut best;
    for (std::size_t i = 0; i < tried_.size() && (i < fewest || best.feature < 0); ++i) {
      std::swap(tried_[i], tried_[i + draw_below(random_, tried_.size() - i)]);
      try_feature(tried_[i], begin, end, all, best);
    }
    return best;
  }

  void make_leaf(std::size_t node, const std::vector<double>& all, std::size_t lessons) {
    nodes[node].threshold = std::numeric_limits<float>::infinity();
    nodes[node].next = static_cast<std::int32_t>(node);
    nodes[node].leaf = static_cast<std::int32_t>(shares.size());
    for (const double count : all) shares.push_back(static_cast<float>(count / static_cast<double>(lessons)));
  }

  /// Between the largest value on one side and the smallest on the other, at random: so that what lies
  /// between strokes belongs to either side, the more the nearer it is.
  float threshold_between(std::size_t feature, std::size_t begin, std::size_t middle, std::size_t end) {
    const auto value = [&](std::size_t i) {
      return lessons_
          .values[static_cast<std::size_t>(drawn_[i]) * static_cast<std::size_t>(lessons_.features) +
                  feature];
    };
    float low = -std::numeric_limits<float>::infinity(), high = -low;
    for (std::size_t i = begin; i < middle; ++i) low = std::max(low, value(i));
    for (std::size_t i = middle; i < end; ++i) high = std::min(high, value(i));
    return low + static_cast<float>(random_.uniform()) * (high - low);
  }

  void grow_node(std::size_t node, std::size_t begin, std::size_t end, int depth) {
    std::vector<double> all(classes_, 0);
    for (std::size_t i = begin; i < end; ++i) ++all[lessons_.classes[static_cast<std::size_t>(drawn_[i])]];
    const bool pure = std::count(all.begin(), all.end(), 0) + 1 == static_cast<std::ptrdiff_t>(classes_);
    const auto enough = static_cast<std::size_t>(2 * options_.least_leaf);
    Cut cut;
    if (!pure && depth < options_.depth && end - begin >= enough) cut = best_cut(begin, end, all);
    if (cut.feature < 0) return make_leaf(node, all, end - begin);
    const auto feature = static_cast<std::size_t>(cut.feature);
    const std::uint8_t* rank = ranked_.rank.data() + feature * lessons_.pixels();
    const auto middle = std::stable_partition(drawn_.begin() + static_cast<std::ptrdiff_t>(begin),
                                              drawn_.begin() + static_cast<std::ptrdiff_t>(end),
                                              [&](std::int32_t lesson) { return rank[lesson] <= cut.rank; });
    const auto middle_at = static_cast<std::size_t>(middle - drawn_.begin());
    const std::size_t next = nodes.size();
    nodes[node].feature = static_cast<std::uint16_t>(cut.feature);
    nodes[node].threshold = threshold_between(feature, begin, middle_at, end);
    nodes[node].next = static_cast<std::int32_t>(next);
    nodes.resize(next + 2);
    grow_node(next, begin, middle_at, depth + 1);
    grow_node(next + 1, middle_at, end, depth + 1);
  }

  const Lessons& lessons_;
  const RankedLessons& ranked_;
  std::size_t classes_;
  ForestOptions options_;
  Random random_;
  std::vector<int> tried_;
  std::vector<std::int32_t> counts_;
  std::vector<std::int32_t> drawn_;
};

/// Node at which a walk down a tree ends.
std::int32_t leaf_node(const std::vector<TreeNode>& nodes, std::int32_t node, const float* values) {
  while (nodes[static_cast<std::size_t>(node)].leaf < 0) {
    const TreeNode& at = nodes[static_cast<std::size_t>(node)];
    node = at.next + (values[at.feature] > at.threshold ? 1 : 0);
  }
  return node;
}

/// Class that the trees which did not see the stroke of a lesson give to it; -1 where all of them saw it.
int class_unseen(const Lessons& lessons, std::size_t lesson, const std::vector<Tree>& trees, int classes) {
  std::vector<double> votes(static_cast<std::size_t>(classes), 0);
  bool asked = false;
  for (const Tree& tree : trees) {
    if (tree.seen.contains(lessons.strokes[lesson])) continue;
    asked = true;
    const float* values = lessons.values.data() + lesson * static_cast<std::size_t>(lessons.features);
    const std::int32_t leaf = tree.nodes[static_cast<std::size_t>(leaf_node(tree.nodes, 0, values))].leaf;
    for (std::size_t k = 0; k < votes.size(); ++k)
      votes[k] += static_cast<double>(tree.shares[static_cast<std::size_t>(leaf) + k]);
  }
  return asked ? static_cast<int>(std::max_element(votes.begin(), votes.end()) - votes.begin()) : -1;
}

/// Share of the lessons of each class that are told rightly by trees that did not see their stroke.
std::vector<double> right_unseen(const Lessons& lessons, const std::vector<Tree>& trees, int classes,
                                 int threads) {
  constexpr std::size_t enough = 5000;  // lessons, to know the shares to a per cent
  const std::size_t step = std::max<std::size_t>(1, lessons.pixels() / enough);
  const std::size_t count = (lessons.pixels() + step - 1) / step;
  std::vector<int> found(count);
  share_out(static_cast<int>(count), threads, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    found[at] = class_unseen(lessons, at * step, trees, classes);
  });
  std::vector<double> right(static_cast<std::size_t>(classes), 0), all = right;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t wanted = lessons.classes[i * step];
    if (found[i] >= 0) ++all[wanted];
    if (found[i] == wanted) ++right[wanted];
  }
  for (std::size_t k = 0; k < right.size(); ++k)
    right[k] = all[k] > 0 ? right[k] / all[k] : std::numeric_limits<double>::quiet_NaN();
  return right;
}

}  // namespace

Taught grow_forest(const Lessons& lessons, int classes, const ForestOptions& options, int threads) {
  const RankedLessons ranked = rank_of_lessons(lessons, threads);
  const auto by_class = bundles_of(lessons, classes);
  std::vector<Tree> trees;
  for (int t = 0; t < options.trees; ++t)
    trees.emplace_back(lessons, ranked, classes, options,
                       options.seed * 1'000'003 + static_cast<std::uint64_t>(t));
  share_out(options.trees, threads, [&](int t) { trees[static_cast<std::size_t>(t)].grow(by_class); });
  Taught taught;
  taught.right = right_unseen(lessons, trees, classes, threads);
  Forest& forest = taught.forest;
  forest.classes = classes;
  forest.features = lessons.features;
  for (const Tree& tree : trees) {
    const auto node = static_cast<std::int32_t>(forest.nodes.size());
    const auto leaf = static_cast<std::int32_t>(forest.shares.size());
    forest.roots.push_back(node);
    for (TreeNode one : tree.nodes) {
      one.next += node;
      if (one.leaf >= 0) one.leaf += leaf;
      forest.nodes.push_back(one);
    }
    forest.shares.insert(forest.shares.end(), tree.shares.begin(), tree.shares.end());
  }
  return taught;
}

namespace {

constexpr std::size_t walkers =
    16;  ///< pixels that walk down a tree side by side, so that none waits for memory

/// Add what trees begin to end - 1 say about up to 16 pixels.
void add_votes(const Forest& forest, std::size_t begin, std::size_t end,
               const std::array<const float*, walkers>& values, const std::array<float*, walkers>& shares,
               std::size_t count) {
  const TreeNode* nodes = forest.nodes.data();
  const auto classes = static_cast<std::size_t>(forest.classes);
  for (std::size_t tree = begin; tree < end; ++tree) {
    std::array<std::int32_t, walkers> at;
    at.fill(forest.roots[tree]);
    for (bool walks = true; walks;) {
      for (int step = 0; step < 3; ++step)
        for (std::size_t i = 0; i < walkers; ++i) {
          const TreeNode& node = nodes[at[i]];
          at[i] = node.next + static_cast<std::int32_t>(values[i][node.feature] > node.threshold);
        }
      walks = false;
      for (std::size_t i = 0; i < walkers; ++i) walks |= nodes[at[i]].leaf < 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const float* leaf = forest.shares.data() + nodes[at[i]].leaf;
      for (std::size_t k = 0; k < classes; ++k) shares[i][k] += leaf[k];
    }
  }
}

/// The same for any number of pixels; walkers without a pixel of their own follow the first one.
void add_votes(const Forest& forest, std::size_t begin, std::size_t end, const float* values,
               const std::vector<int>& pixels, float* shares) {
  const auto classes = static_cast<std::size_t>(forest.classes);
  const auto features = static_cast<std::size_t>(forest.features);
  for (std::size_t first = 0; first < pixels.size(); first += walkers) {
    const std::size_t count = std::min(walkers, pixels.size() - first);
    std::array<const float*, walkers> from;
    std::array<float*, walkers> to{};
    for (std::size_t i = 0; i < walkers; ++i) {
      const auto pixel = static_cast<std::size_t>(pixels[first + (i < count ? i : 0)]);
      from[i] = values + pixel * features;
      to[i] = shares + pixel * classes;
    }
    add_votes(forest, begin, end, from, to, count);
  }
}

}  // namespace

void ask_forest(const Forest& forest, const float* values, int pixels, float* shares) {
  const auto classes = static_cast<std::size_t>(forest.classes);
  const std::size_t trees = forest.roots.size(), first_part = std::max<std::size_t>(1, trees / 4);
  std::fill(shares, shares + static_cast<std::size_t>(pixels) * classes, 0.0F);
  std::vector<int> asked(static_cast<std::size_t>(pixels));
  std::iota(asked.begin(), asked.end(), 0);
  add_votes(forest, 0, first_part, values, asked, shares);
  std::erase_if(asked, [&](int pixel) {
    float* share = shares + static_cast<std::size_t>(pixel) * classes;
    const auto all = static_cast<float>(first_part);
    if (*std::max_element(share, share + classes) < unanimous * all) return false;
    for (std::size_t k = 0; k < classes; ++k) share[k] /= all;
    return true;
  });
  add_votes(forest, first_part, trees, values, asked, shares);
  for (const int pixel : asked)
    for (std::size_t k = 0; k < classes; ++k)
      shares[static_cast<std::size_t>(pixel) * classes + k] /= static_cast<float>(trees);
}

}  // namespace specimen
