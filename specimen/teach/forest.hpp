/// A random forest: phases learnt from the features of pixels whose phase is known.
#pragma once

#include <cstdint>
#include <vector>

namespace specimen {

/// Pixels whose class is known.
struct Lessons {
  int features = 0;                   ///< of a pixel
  std::vector<float> values;          ///< shape (pixels, features)
  std::vector<std::uint8_t> classes;  ///< 0, 1, ... of each pixel
  std::vector<std::int32_t> strokes;  ///< number of the stroke that each pixel lies under, from 0
  [[nodiscard]] std::size_t pixels() const { return classes.size(); }
};

struct ForestOptions {
  int trees = 100;
  int depth = 14;      ///< of a tree, at most
  int least_leaf = 3;  ///< lessons in a leaf, at least
  int lessons = 4000;  ///< of each class for a tree, at most
  std::uint64_t seed = 1;
};

/// A node of a tree: to the node `next` where the feature is at most the threshold, else to the one after it.
/// A leaf leads to itself whatever the feature, and holds the shares of the classes that begin at `leaf`.
struct TreeNode {
  float threshold = 0;
  std::uint16_t feature = 0;
  std::int32_t next = 0;   ///< number among the nodes of the forest
  std::int32_t leaf = -1;  ///< of a leaf: where its shares begin; -1 = none
  friend bool operator==(const TreeNode&, const TreeNode&) = default;
};

/// Trees one after the other; plain data, so that it can be kept in a file.
struct Forest {
  int classes = 0, features = 0;
  std::vector<std::int32_t> roots;  ///< node of each tree's root
  std::vector<TreeNode> nodes;
  std::vector<float> shares;  ///< of the classes in the leaves [-]
  friend bool operator==(const Forest&, const Forest&) = default;
};

/// What teaching tells about itself.
struct Taught {
  Forest forest;
  /// Share of the lessons that trees which did not see their stroke sort rightly [-], by class; NaN for a
  /// class that has too few strokes for that.
  std::vector<double> right;
};

/// Grow a forest. Each tree sees as many lessons of each class as of any other, from strokes that are drawn
/// with repetition, so that neither long strokes nor many of them outweigh the rest, and a tree knows whole
/// strokes that others do not. A node parts its lessons by the better of two features, drawn at random, at
/// the rank of 256 that is best by Gini's impurity, and between the values there at random: so all features
/// have a say in what lies between the phases, not only those that part the strokes best. The same lessons
/// and seed give the same forest on every machine and any number of threads.
/// @param classes  number of classes, 2 to 255, each of which has a lesson.
/// Sources: Breiman (2001); few features a node, Geurts, Ernst, Wehenkel (2006); as many of each class, Chen,
/// Liaw, Breiman (2004).
[[nodiscard]] Taught grow_forest(const Lessons& lessons, int classes, const ForestOptions& options,
                                 int threads);

/// Mean shares of the classes over the trees; over the first quarter of them where these agree to 95 %, which
/// most pixels need no more than. Source of such early ends: Hernandez-Lobato, Martinez-Munoz, Suarez (2009).
/// @param values  features, shape (pixels, forest.features).   @param[out] shares  shape (pixels,
/// forest.classes), sum of a pixel 1.
void ask_forest(const Forest& forest, const float* values, int pixels, float* shares);

}  // namespace specimen
