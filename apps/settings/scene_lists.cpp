#include "apps/settings/scene_lists.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>

namespace app {
namespace {

template <class T>
using ItemsOf = std::vector<T>& (*)(Settings&);

/// @param fields  of one item.   @param items  where they stand.
template <class T>
std::vector<Field> bound(const char* list, const std::vector<FieldOf<T>>& fields, ItemsOf<T> items,
                         std::size_t index) {
  std::vector<Field> all;
  for (const FieldOf<T>& field : fields)
    all.push_back({fmt::format("{}[{}].{}", list, index + 1, field.key), field.help, field.form,
                   [set = field.set, items, index](Settings& settings, const Value& value) {
                     std::vector<T>& own = items(settings);
                     if (own.size() <= index) own.resize(index + 1);
                     set(own[index], value);
                   },
                   [get = field.get, items, index](const Settings& settings) {
                     // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast) ; which it only reads
                     const std::vector<T>& own = items(const_cast<Settings&>(settings));
                     return get(index < own.size() ? own[index] : T{});
                   }});
  return all;
}

QuantityCodec of_length(Bounds bounds) { return {Dimension::length, bounds}; }

ChoiceCodec<mpm::Side> sides() {
  using mpm::Side;
  return {{{"bottom", Side::bottom}, {"top", Side::top}, {"left", Side::left}, {"right", Side::right}}};
}

/// The keys of a stretch of the outline.
template <class T>
std::vector<FieldOf<T>> stretch_fields() {
  return {
      make_field<T>(
          "at", "side of the specimen, which is met where its material begins", sides(),
          [](auto& one) -> auto& { return one.at.side; }),
      make_field<T>(
          "from", "where it begins along that side, from the lower left corner", of_length(at_least(0)),
          [](auto& one) -> auto& { return one.at.from; }),
      make_field<T>(
          "to", "where it ends; end = with the side",
          QuantityCodec{Dimension::length, at_least(0), Word{"end", unlimited}},
          [](auto& one) -> auto& { return one.at.to; }),
  };
}

FieldOf<mpm::Bearing> fix_field() {
  const WordCodec words{{"x", "y", "xy"}};
  return {"fix", "axes along which it holds", words.form(),
          [words](mpm::Bearing& support, const Value& value) {
            const std::string word = words.read(value);
            support.fix_x = word != "y";
            support.fix_y = word != "x";
          },
          [words](const mpm::Bearing& support) {
            return words.write(!support.fix_x ? "y" : support.fix_y ? "xy" : "x");
          }};
}

std::vector<Field> supports(std::size_t index) {
  std::vector<FieldOf<mpm::Bearing>> fields = stretch_fields<mpm::Bearing>();
  fields.push_back(fix_field());
  return bound<mpm::Bearing>(
      "supports", fields, [](Settings & settings) -> auto& { return settings.scene.fixture.supports; },
      index);
}

std::vector<Field> loads(std::size_t index) {
  using mpm::Load;
  using mpm::Way;
  const ChoiceCodec<Way> way{
      {{"up", Way::up}, {"down", Way::down}, {"left", Way::left}, {"right", Way::right}}};
  std::vector<FieldOf<Load>> fields = stretch_fields<Load>();
  fields.push_back(make_field<Load>("displacement", "where it moves to", way, &Load::way));
  fields.push_back(make_field<Load>("leads", "its displacement is that of the test; of one load alone it is",
                                    BooleanCodec{}, &Load::leads));
  fields.push_back(make_field<Load>("share", "of another load, displacement over that of the leading one",
                                    QuantityCodec{Dimension::ratio}, &Load::share));
  fields.push_back(make_field<Load>("grips", "hold its nodes across its way too, as a rough platen does",
                                    BooleanCodec{}, &Load::grips));
  return bound<Load>(
      "loads", fields, [](Settings & settings) -> auto& { return settings.scene.fixture.loads; }, index);
}

/// A point as [x, y].
FieldOf<mpm::Gauge> point_field(const char* key, const char* help, double mpm::Gauge::*x,
                                double mpm::Gauge::*y) {
  const LengthsCodec codec{2, "X,Y", "must be x and y, e.g. [\"98 mm\", \"0 mm\"]"};
  return {key, help, codec.form(),
          [codec, x, y](mpm::Gauge& gauge, const Value& value) {
            const std::vector<double> point = codec.read(value);
            if (point.empty()) throw Mistake(codec.allowed);
            gauge.*x = point[0];
            gauge.*y = point[1];
          },
          [codec, x, y](const mpm::Gauge& gauge) {
            return codec.write({gauge.*x, gauge.*y});
          }};
}

std::vector<Field> gauges(std::size_t index) {
  using mpm::Gauge;
  const ChoiceCodec<Gauge::Direction> direction{
      {{"along", Gauge::Direction::along}, {"x", Gauge::Direction::x}, {"y", Gauge::Direction::y}}};
  const std::vector<FieldOf<Gauge>> fields{
      make_field<Gauge>("name", "of its column: letters, digits, _ and -", TextCodec{}, &Gauge::name),
      point_field("from", "point [x, y], from the lower left corner", &Gauge::x1, &Gauge::y1),
      point_field("to", "the other one; the reading is how far both have moved apart", &Gauge::x2,
                  &Gauge::y2),
      make_field<Gauge>("direction", "along the line between them, or along an axis", direction,
                        &Gauge::direction),
      make_field<Gauge>("until", "reading at which the run ends",
                        OptionalQuantityCodec{of_length(above(0)), "none"}, &Gauge::until),
      make_field<Gauge>("controls", "its reading never falls, and the load may snap back", BooleanCodec{},
                        &Gauge::controls),
  };
  return bound<Gauge>(
      "gauges", fields, [](Settings & settings) -> auto& { return settings.scene.fixture.gauges; }, index);
}

std::vector<Field> cuts(std::size_t index) {
  const LengthsCodec rectangle{
      4, "X,Y,WIDTH,HEIGHT",
      "must be x, y of the lower left corner, width and height, e.g. [\"98 mm\", \"0 "
      "mm\", \"4 mm\", \"25 mm\"]"};
  const LengthsCodec circle{
      3, "X,Y,RADIUS", "must be x, y of the centre and the radius, e.g. [\"50 mm\", \"50 mm\", \"10 mm\"]"};
  const std::vector<FieldOf<Cut>> fields{
      make_field<Cut>("rectangle", "lower left corner, width and height of what is cut out", rectangle,
                      &Cut::rectangle),
      make_field<Cut>("circle", "centre and radius of it, in place of a rectangle", circle, &Cut::circle),
      make_field<Cut>("keeps", "inside = all beyond it is cut off instead",
                      ChoiceCodec<bool>{{{"outside", false}, {"inside", true}}}, &Cut::keeps_inside),
  };
  return bound<Cut>(
      "cuts", fields, [](Settings & settings) -> auto& { return settings.cuts; }, index);
}

}  // namespace

const std::vector<SceneList>& scene_lists() {
  static const std::vector<SceneList> all{
      {"cuts",
       "a cut",
       "Notches and cut-outs, which make void of the specimen; places from its lower left corner.",
       {},
       &cuts,
       [](const Settings& settings) { return settings.cuts.size(); }},
      {"supports",
       "a support",
       "Parts of the outline that do not move, where loads take the place of the platens.",
       {"at", "fix"},
       &supports,
       [](const Settings& settings) { return settings.scene.fixture.supports.size(); }},
      {"loads",
       "a load",
       "Parts of the outline that are moved, in place of the platens; one of them leads.",
       {"at", "displacement"},
       &loads,
       [](const Settings& settings) { return settings.scene.fixture.loads.size(); }},
      {"gauges",
       "a gauge",
       "Pairs of points of which the run records how far they move apart.",
       {"name", "from", "to"},
       &gauges,
       [](const Settings& settings) { return settings.scene.fixture.gauges.size(); }},
  };
  return all;
}

const SceneList* find_list(std::string_view name) {
  const auto& all = scene_lists();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const SceneList& list) { return list.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::optional<Field> find_item_field(std::string_view key) {
  const std::size_t open = key.find('['), close = key.find("].");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return std::nullopt;
  const SceneList* list = find_list(key.substr(0, open));
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(key.data() + open + 1, key.data() + close, number);
  if (list == nullptr || error != std::errc() || end != key.data() + close || number < 1 ||
      number > most_items)
    return std::nullopt;
  for (Field& field : list->fields(number - 1))
    if (field.key == key) return std::move(field);
  return std::nullopt;
}

bool is_empty_list(const Value& value) {
  const auto* list = std::get_if<Value::List>(&value.data);
  return list != nullptr && list->empty();
}

std::vector<std::string> item_keys(const SceneList& list) {
  std::vector<std::string> keys;
  for (const Field& field : list.fields(0)) keys.push_back(leaf_of(field.key));
  return keys;
}

}  // namespace app
