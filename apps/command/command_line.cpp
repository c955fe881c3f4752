#include "apps/command/command_line.hpp"

#include <algorithm>
#include <set>

#include "apps/text/words.hpp"

namespace app {
namespace {

bool among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A default as the help shows it; settings that have none give an empty text.
std::string default_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  if (std::holds_alternative<bool>(value.data) || std::holds_alternative<Value::List>(value.data)) return {};
  return toml_text(value);
}

std::string described(const std::string& help, const std::string& default_value) {
  return default_value.empty() ? help : help + " [" + default_value + "]";
}

/// Argument "--NAME=VALUE" in two; without "=" the value is absent.
struct LongOption {
  std::string name;
  std::optional<std::string> value;
};

std::optional<LongOption> long_option(const std::string& argument) {
  if (argument.size() < 3 || argument.compare(0, 2, "--") != 0) return std::nullopt;
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos) return LongOption{argument.substr(2), std::nullopt};
  return LongOption{argument.substr(2, equals - 2), argument.substr(equals + 1)};
}

/// An option with one value whose text is read after parsing.
CLI::Option* add_text_option(Options& options, const std::string& names, const std::string& help, Form form) {
  const CLI::callback_t take = [](const CLI::results_t&) { return true; };
  return options.expect(options.add_option(names, take, help)->expected(1), std::move(form));
}

/// What --set may begin with: "loading.velocity=".
std::vector<std::string> keys_of(const Offer& offer) {
  std::vector<std::string> keys;
  for (const std::string& key : every_key(Settings()))
    if (offer.has(key)) keys.push_back(key + "=");
  return keys;
}

class Formatter : public CLI::Formatter {
 public:
  Formatter() {
    column_width(38);
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
    label("OPTIONS", "OPTION...");
  }

  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    if (is_positional) return option->get_name(true, false);
    std::string name;
    for (const std::string& letter : option->get_snames()) name += "-" + letter + ", ";
    return option->get_lnames().empty() ? name : name + "--" + option->get_lnames().front();
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const bool flag = option->get_items_expected_max() == 0;
    return flag || option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }

  /// An argument that may be left out has brackets in its name.
  std::string make_option_usage(const CLI::Option* option) const override {
    return option->get_name(true, false);
  }

  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    std::string text = CLI::Formatter::make_group(std::move(group), is_positional, std::move(options));
    while (text.size() > 1 && text.compare(text.size() - 2, 2, "\n\n") == 0) text.pop_back();
    return text;
  }

  std::string make_subcommand(const CLI::App* command) const override {
    std::string first = command->get_description();
    first.resize(std::min(first.size(), first.find('\n')));
    std::ostringstream out;
    CLI::detail::format_help(out, command->get_name(), first, 14);
    return out.str();
  }
};

}  // namespace

Options& Options::below(CLI::App& parent, const std::string& name, const std::string& description) {
  const auto options = std::make_shared<Options>(name, description, &parent);
  parent.add_subcommand(options);
  return *options;
}

CLI::Option* Options::expect(CLI::Option* option, Form form) {
  option->type_name(option->get_positional() ? "" : type(form));
  forms_[option] = std::move(form);
  return option;
}

Form form_of(const CLI::App& command, const CLI::Option& option) {
  const auto* options = dynamic_cast<const Options*>(&command);
  if (options != nullptr)
    if (const auto found = options->forms_.find(&option); found != options->forms_.end())
      return found->second;
  return BooleanCodec::form();
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& letter : option.get_snames()) names.push_back("-" + letter);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

SettingOptions::SettingOptions(Options& options, Offer offer) : offer_(std::move(offer)) {
  Form key_and_value = text_form("KEY=VALUE");
  key_and_value.hints = keys_of(offer_);
  set_ = add_text_option(options, "--set", "any setting by its key in scene files", std::move(key_and_value));
  set_->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  for (const Group& group : groups()) {
    if (offer_.is_own(group.name)) add_group(options, group, true);
    if (among(offer_.others, group.name)) add_group(options, group, false);
  }
}

void SettingOptions::add_group(Options& options, const Group& group, bool in_help) {
  if (group.name == "phases" && in_help) add_phase_help(options, group);
  for (const Field& field : fields_of(group.name))
    if (offer_.has(field.key)) add_field(options, group, field, in_help);
}

void SettingOptions::add_field(Options& options, const Group& group, const Field& field, bool in_help) {
  std::string names = "--" + with_dashes(field.key);
  if (in_help) names = "--" + short_option(group, field) + "," + names;
  static const Settings defaults;
  const std::string help = described(field.help, default_text(field.get(defaults)));
  CLI::Option* option = field.form.kind == Kind::boolean ? options.add_flag(names, help)
                                                         : add_text_option(options, names, help, field.form);
  option->group(in_help ? group.title : "")->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  bound_.push_back({field, option});
}

void SettingOptions::add_phase_help(Options& options, const Group& group) {
  for (const PhaseField& property : phase_fields())
    if (offer_.has("phases." + property.key))
      add_text_option(options, "--PHASE." + with_dashes(property.key), property.help, property.form)
          ->group(group.title + " (PHASE = aggregate, mortar, itz, or one of your own)");
}

std::vector<std::string> SettingOptions::take_phase_options(const std::vector<std::string>& arguments) {
  std::vector<std::string> rest;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto option = long_option(arguments[i]);
    if (!option) {
      rest.push_back(arguments[i]);
      continue;
    }
    const std::string key = offer_.is_own("phases") ? phase_key(option->name) : "";
    if (key.empty()) {
      rest.push_back("--" + with_dashes(option->name) + (option->value ? "=" + *option->value : ""));
      continue;
    }
    const bool value_follows = !option->value && i + 1 < arguments.size();
    const std::string value = option->value ? *option->value : value_follows ? arguments[++i] : "";
    phases_.push_back(given_as_option(key, find_field(key)->form.kind, "--" + option->name, value));
  }
  return rest;
}

Assignment SettingOptions::from_set(const std::string& text) const {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw Rejected(Exit::usage, "--set", text, "must be KEY=VALUE",
                   "write e.g. --set \"loading.velocity=0.1 m/s\"");
  const std::string key = text.substr(0, equals);
  const std::string value = text.substr(equals + 1);
  const auto field = find_field(key);
  if (!field) throw Rejected(Exit::usage, unknown_key({}, "--set " + key, suggest_key(key, Settings())));
  if (!offer_.has(key)) throw Rejected(Exit::usage, "--set " + key, "has no effect here", "remove it");
  return given_as_option(key, field->form.kind, "--set " + key, value);
}

std::vector<Assignment> SettingOptions::assignments() const {
  std::vector<Assignment> given = phases_;
  for (const Bound& bound : bound_)
    for (const std::string& text : bound.option->results())
      given.push_back(given_as_option(bound.field.key, bound.field.form.kind,
                                      "--" + bound.option->get_lnames().front(), text));
  for (const std::string& text : set_->results()) given.push_back(from_set(text));
  std::set<std::string> keys;
  for (const Assignment& one : given)
    if (!keys.insert(one.key).second)
      throw Rejected(Exit::usage, one.field, one.written, "is given twice", "give it once");
  return given;
}

std::shared_ptr<CLI::Formatter> help_formatter() { return std::make_shared<Formatter>(); }

namespace {

/// "mesopix study submit".
std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  const bool below_another = parent != nullptr && parent->get_parent() != nullptr;
  return (below_another ? full_name(*parent) : "mesopix") + " " + command.get_name();
}

}  // namespace

void refuse_remaining(const CLI::App& command) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  if (among(known, "--PHASE.young"))
    for (const std::string& key : every_key(Settings()))
      if (group_of(key) == "phases") known.push_back("--" + with_dashes(key.substr(key.find('.') + 1)));
  std::vector<Complaint> complaints;
  const std::vector<std::string> remaining = command.remaining();
  // Behind an unknown option stands its value, which would be a confusing second complaint.
  for (const std::string& argument : remaining)
    if (argument.size() > 1 && argument.front() == '-') {
      const std::string name = argument.substr(0, argument.find('='));
      complaints.push_back(complaint(name, "unknown option", did_you_mean(name, known),
                                     full_name(command) + " --help lists them"));
    }
  if (complaints.empty() && !remaining.empty())
    complaints.push_back(
        complaint(remaining.front(), "one argument too many", "", full_name(command) + " --help"));
  if (!complaints.empty()) throw Rejected(Exit::usage, complaints);
}

}  // namespace app
