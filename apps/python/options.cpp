#include "apps/python/options.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "apps/text/quantity.hpp"

namespace binding {
namespace {

bool is_boolean(py::handle value) {
  return PyBool_Check(value.ptr()) || py::isinstance(value, py::module_::import("numpy").attr("bool_"));
}

/// A whole number too large for the program keeps its text, which its codec then refuses.
app::Value whole_number(py::handle value) {
  int overflow = 0;
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  const long long number = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
  if (overflow != 0) return {py::str(value).cast<std::string>()};
  return {static_cast<std::int64_t>(number)};
}

bool is_number(py::handle value) {
  return PyFloat_Check(value.ptr()) ||
         (py::hasattr(value, "__float__") && !py::hasattr(value, "__len__") && !PyComplex_Check(value.ptr()));
}

app::Value scalar(py::handle value) {
  if (py::isinstance<py::str>(value)) return {value.cast<std::string>()};
  if (is_boolean(value)) return {value.cast<bool>()};
  if (PyIndex_Check(value.ptr()) != 0 && !py::hasattr(value, "__len__")) return whole_number(value);
  if (is_number(value)) return {py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>()};
  throw app::Mistake("must be a number, a text such as \"0.5 mm\", True or False, or a sequence of these");
}

app::Value list_of(py::handle value) {
  app::Value::List items;
  if (py::isinstance<py::dict>(value)) {
    for (const auto& [label, name] : value.cast<py::dict>())
      items.push_back({py::str(label).cast<std::string>() + ": " + py::str(name).cast<std::string>()});
  } else {
    for (const py::handle item : value) items.push_back(scalar(item));
  }
  return {std::move(items)};
}

bool is_list(py::handle value) {
  return !py::isinstance<py::str>(value) && !py::isinstance<py::bytes>(value) &&
         py::hasattr(value, "__len__") && py::hasattr(value, "__iter__");
}

/// Numbers are in SI units, which a scene has to write behind them.
app::Value with_unit(const app::Field& field, app::Value value) {
  if (!field.form.measure || field.form.measure->dimension == app::Dimension::ratio) return value;
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) number = static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value.data)) number = *real;
  if (!std::isfinite(number)) return value;
  return {app::format_quantity(number, field.form.measure->dimension)};
}

std::string written(py::handle value) {
  return py::isinstance<py::str>(value) ? value.cast<std::string>() : py::repr(value).cast<std::string>();
}

/// Collects what was given, and every complaint about it.
class Collector {
 public:
  explicit Collector(const app::Offer& offer) : offer_(offer) {}

  void add(const std::string& name, py::handle value) {
    try {
      const std::string key = key_named(offer_, name);
      if (!keys_.insert(key).second)
        return complain(app::complaint(name, written(value), "is given twice", "give it once"));
      given_.push_back({key, value_of(*app::find_field(key), value), {}, name, written(value)});
    } catch (const app::Rejected& unknown) {
      complain(unknown.complaints.front());
    } catch (const app::Mistake& mistake) {
      complain(app::complaint(name, written(value), mistake.allowed, mistake.cure));
    }
  }

  std::vector<app::Assignment> result() {
    if (!complaints_.empty()) throw app::Rejected(app::Exit::usage, complaints_);
    return std::move(given_);
  }

 private:
  void complain(app::Complaint complaint) { complaints_.push_back(std::move(complaint)); }

  const app::Offer& offer_;
  std::set<std::string> keys_;
  std::vector<app::Assignment> given_;
  std::vector<app::Complaint> complaints_;
};

std::string default_text(const app::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  return app::toml_text(value);
}

template <class Field, class Object>
py::tuple row(const std::string& name, const std::string& key, const Field& field, const Object& defaults) {
  const std::string type = field.form.kind == app::Kind::boolean ? "BOOLEAN" : app::type(field.form);
  return py::make_tuple(name, key, type, default_text(field.get(defaults)), field.help);
}

}  // namespace

app::Value value_of(const app::Field& field, py::handle value) {
  if (py::isinstance<py::str>(value))
    return app::from_command_line(field.form.kind, value.cast<std::string>());
  if (is_path(value)) return {path_text(py::reinterpret_borrow<py::object>(value))};
  if (is_list(value)) return list_of(value);
  return with_unit(field, scalar(value));
}

app::Value plain_value(py::handle value) {
  return !py::isinstance<py::str>(value) && py::hasattr(value, "__iter__") ? list_of(value) : scalar(value);
}

std::vector<app::Assignment> assignments(const app::Offer& offer, const py::dict& settings,
                                         const py::dict& options) {
  Collector collector(offer);
  for (const py::dict& part : {settings, options})
    for (const auto& [name, value] : part) collector.add(py::str(name).cast<std::string>(), value);
  return collector.result();
}

std::string option_text(const py::object& value, const char* unit) {
  if (value.is_none()) return {};
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  const std::string number = py::str(value).cast<std::string>();
  return *unit == '\0' ? number : number + " " + unit;
}

void take(const py::dict& wanted, const char* name, std::string& text, const char* unit) {
  if (const py::object value = wanted[name]; !value.is_none()) text = option_text(value, unit);
}

app::Origins with_output(const char* argument, app::Origins origins) {
  origins["-o"] = {"-o", {}, {}, argument, ""};
  return origins;
}

py::list described(const app::Offer& offer) {
  app::Settings defaults;
  const mpm::Phase mortar = app::phase_named(defaults, "mortar");
  py::list rows;
  for (const app::Group& group : app::groups()) {
    if (!offer.is_own(group.name)) continue;
    if (group.name == "phases")
      for (const app::PhaseField& property : app::phase_fields())
        if (offer.has("phases." + property.key))
          rows.append(row("PHASE." + property.key, "phases.PHASE." + property.key, property, mortar));
    for (const app::Field& field : app::fields_of(group.name))
      if (offer.has(field.key))
        rows.append(row(app::with_underscores(app::short_option(group, field)), field.key, field, defaults));
  }
  return rows;
}

bool is_path(py::handle value) { return py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__"); }

std::string path_text(const py::object& path) {
  return py::module_::import("os").attr("fsdecode")(path).cast<std::string>();
}

}  // namespace binding
