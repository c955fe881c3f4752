#include "apps/reproduce/figure_table.hpp"

#include <algorithm>

#include "apps/text/complaint.hpp"
#include "apps/text/suggestion.hpp"

namespace app::reproduce {
namespace {

bool has_id(const Figure& figure, const std::string& id) {
  return std::find(figure.ids.begin(), figure.ids.end(), id) != figure.ids.end();
}

void check_id(const std::string& id) {
  std::vector<std::string> known;
  for (const Figure& figure : figures()) {
    if (has_id(figure, id)) return;
    known.insert(known.end(), figure.ids.begin(), figure.ids.end());
  }
  throw Rejected(Exit::usage, complaint("--figure", id, "must be " + listed(known),
                                        "leave it out, or give --all, for all of them"));
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      generation_figure(), weibull_figure(),        curves_figure(),
      damage_figure(),     two_aggregates_figure(), modulus_figure(),
      strength_figure(),   cohesion_figure(),       objectivity_figure(),
  };
  return all;
}

std::vector<const Figure*> select_figures(const std::vector<std::string>& ids) {
  for (const std::string& id : ids) check_id(id);
  std::vector<const Figure*> selected;
  for (const Figure& figure : figures())
    if (ids.empty() ||
        std::any_of(ids.begin(), ids.end(), [&](const auto& id) { return has_id(figure, id); }))
      selected.push_back(&figure);
  return selected;
}

std::string name_of(const Figure& figure) {
  if (figure.ids == std::vector<std::string>{"objectivity"}) return "Objectivity";
  if (figure.ids.size() == 1) return "Figure " + figure.ids.front();
  return "Figures " + figure.ids.front() + (figure.ids.size() == 2 ? " and " : " to ") + figure.ids.back();
}

}  // namespace app::reproduce
