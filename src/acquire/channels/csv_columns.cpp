#include "acquire/channels/csv_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "acquire/channels/column_words.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

std::optional<Quantity> quantity_of(const CsvColumn& column) {
  const auto unit = parse_unit(column.unit);
  return unit ? std::optional(unit->quantity) : std::nullopt;
}

bool is_named(const CsvColumn& column, const std::string& name) {
  const std::string wanted = lower_case(name);
  return lower_case(column.name) == wanted || lower_case(column.base) == wanted;
}

bool is_number_of(const CsvColumn& column, const std::string& name) { return name == std::to_string(column.index + 1); }

std::string list_of(const std::vector<CsvColumn>& columns) {
  constexpr std::size_t kShown = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(columns.size(), kShown); ++i) {
    const auto& column = columns[i];
    const bool show_unit = !column.unit.empty() && column.base == column.name;
    const std::string shown = !column.shape.empty() ? column.shape : show_unit ? column.unit : "";
    text += (i == 0 ? "" : ", ") + one_line(column.name, 40) + (shown.empty() ? "" : " [" + one_line(shown, 20) + "]");
  }
  if (columns.size() > kShown) text += fmt::format(", … ({} in all)", columns.size());
  return text;
}

class Finder {
 public:
  Finder(const CsvHeader& header, const ReadOptions& options, const std::string& file)
      : header_(header),
        options_(options),
        where_(header.text ? file + (header.named ? ": header" : ": no header with names") : file) {}

  CsvColumns find() {
    require_setup_columns();
    columns_.hit = column_called("hit");
    columns_.point = column_called("point");
    columns_.run = column_called("run");
    columns_.time = find_time();
    try {
      find_force();
      find_accel();
    } catch (AmbiguousColumns& error) {
      error.known = columns_;
      throw;
    }
    return std::move(columns_);
  }

 private:
  std::optional<CsvColumn> column_called(const std::string& name) const {
    for (const auto& column : header_.columns) {
      if (column.has_numbers && header_.named && lower_case(column.name) == name) return column;
    }
    return std::nullopt;
  }

  // A misspelt name must not lose its sensor silently.
  void require_setup_columns() const {
    if (!options_.accel_channels.empty()) return;  // the user has chosen
    for (const auto& entry : options_.setup) {
      if (entry.role == "ignore") continue;
      const bool known = std::any_of(header_.columns.begin(), header_.columns.end(),
                                     [&](const CsvColumn& column) { return is_called(column, entry.name); });
      if (!known) {
        throw InputError("no column \"" + one_line(entry.name, 40) + "\" among " + list_of(header_.columns),
                         where_ + ": channel set-up",
                         "correct the name in the set-up, give the number from 1 in its place, or remove the entry");
      }
    }
  }

  std::optional<CsvColumn> find_time() const {
    for (const auto& column : header_.columns) {
      if (column.has_numbers && header_.named && is_one_of(lower_case(column.base), kTimeWords)) return column;
    }
    for (const auto& column : header_.columns) {
      if (column.has_numbers && column.index == 0 && quantity_of(column) == Quantity::time) return column;
    }
    return std::nullopt;
  }

  // The column that the user named in `option`.
  CsvColumn named_by_user(const std::string& name, const OptionId& option) const {
    std::vector<CsvColumn> found;
    for (const auto matches :
         {+[](const CsvColumn&c, const std::string&n) { return lower_case(c.name) == lower_case(n); }, &is_named,
          &is_number_of}) {
      for (const auto& column : header_.columns) {
        if (found.empty() || found.front().index != column.index) {
          if (matches(column, name)) found.push_back(column);
        }
      }
      if (!found.empty()) break;
    }
    const std::string shown = "\"" + one_line(name, 40) + "\"";
    if (found.empty()) {
      throw InputError("no column " + shown + " among " + list_of(header_.columns), where_, "name one of these",
                       {option});
    }
    if (found.size() > 1) {
      throw InputError("several columns are called " + shown, where_,
                       fmt::format("give its number, for instance {}", found.front().index + 1), {option});
    }
    if (!found.front().has_numbers)
      throw InputError("column " + shown + " holds no numbers", where_, "name another column", {option});
    return found.front();
  }

  // The role that the set-up gives a column; empty for none.
  std::string role_of(const CsvColumn& column) const {
    const auto* setup = setup_of(column, options_);
    return setup == nullptr ? "" : setup->role;
  }

  bool could_be(const CsvColumn& column, Quantity quantity, Words words) const {
    if (!column.has_numbers || is_helper(column, columns_)) return false;
    if (const auto measured = quantity_of(column)) {
      if (*measured == quantity) return true;
      const bool pounds = quantity == Quantity::force && *measured == Quantity::mass;  // of force, if the name says so
      if (*measured != Quantity::voltage && !pounds) return false;
    }
    // A word counts only in a file with names. A force word counts only without an acceleration word in the same name.
    const std::string name = lower_case(column.base);
    const Words other = quantity == Quantity::force ? Words(kAccelWords) : Words();
    return header_.named && has_one_of(name, words) && !has_one_of(name, other);
  }

  std::vector<CsvColumn> candidates(Quantity quantity, Words words, const std::string& role) const {
    std::vector<CsvColumn> by_role, by_header;
    for (const auto& column : header_.columns) {
      const std::string given = role_of(column);
      if (given == role) by_role.push_back(column);
      if (given.empty() && could_be(column, quantity, words)) by_header.push_back(column);
    }
    return by_role.empty() ? by_header : by_role;
  }

  void find_force() {
    std::vector<CsvColumn> found;
    if (options_.force_channel.empty()) {
      found = candidates(Quantity::force, kForceWords, "force");
    } else {
      found.push_back(named_by_user(options_.force_channel, "force_channel"));
    }
    if (found.empty() && options_.force_optional) return;
    if (found.empty()) {
      throw AmbiguousColumns("no force column found among " + list_of(header_.columns), where_, "name the force",
                             header_, {"force_channel"});
    }
    if (found.size() > 1) {
      throw AmbiguousColumns(fmt::format("{} columns could be the force: {}", found.size(), list_of(found)), where_,
                             "name the force", header_, {"force_channel"});
    }
    columns_.force = found.front();
    columns_.has_force = true;
  }

  bool is_force(const CsvColumn& column) const { return columns_.has_force && column.index == columns_.force.index; }

  void find_accel() {
    for (const auto& name : options_.accel_channels) {
      const auto column = named_by_user(name, "accel_channel");
      const bool twice =
          std::any_of(columns_.accel.begin(), columns_.accel.end(), [&](auto& c) { return c.index == column.index; });
      if (twice || is_force(column)) {
        throw InputError("column \"" + one_line(column.name, 40) + "\" is named twice", where_,
                         "give each column one role");
      }
      columns_.accel.push_back(column);
    }
    if (!columns_.accel.empty()) return;
    for (const auto& column : candidates(Quantity::acceleration, kAccelWords, "acceleration")) {
      if (!is_force(column)) columns_.accel.push_back(column);
    }
    if (columns_.accel.empty() && !columns_.has_force) find_only_response();
    if (!columns_.accel.empty()) return;
    refuse_velocities();
    if (!columns_.has_force) {
      throw AmbiguousColumns("neither a force nor an acceleration column found among " + list_of(header_.columns),
                             where_, "name the force and the accelerations, or the accelerations alone", header_,
                             {"force_channel", "accel_channel"});
    }
    throw AmbiguousColumns("no acceleration column found among " + list_of(header_.columns), where_,
                           "name the accelerations", header_, {"accel_channel"});
  }

  // A laser vibrometer measures velocities, which no option turns into accelerations.
  void refuse_velocities() const {
    for (const CsvColumn& column : header_.columns) {
      if (!column.has_numbers || quantity_of(column) != Quantity::velocity) continue;
      throw AmbiguousColumns("no acceleration, but " + one_line(column.name, 40) + " is a velocity", where_,
                             "differentiate the velocities, or give FRFs of them as mobility", header_, {"frf_kind"});
    }
  }

  // A file without force and accelerations holds the responses of microphones: sound pressures, or one signal of no
  // stated quantity.
  void find_only_response() {
    std::vector<CsvColumn> signals;
    for (const CsvColumn& column : header_.columns) {
      if (!column.has_numbers || is_helper(column, columns_) || role_of(column) == "ignore") continue;
      signals.push_back(column);
      if (quantity_of(column) == Quantity::pressure) columns_.accel.push_back(column);
    }
    if (!columns_.accel.empty()) return;
    if (signals.size() == 1 && (!quantity_of(signals.front()) || *quantity_of(signals.front()) == Quantity::voltage))
      columns_.accel = std::move(signals);
  }

  const CsvHeader& header_;
  const ReadOptions& options_;
  std::string where_;
  CsvColumns columns_;
};

}  // namespace

CsvColumns find_csv_columns(const CsvHeader& header, const ReadOptions& options, const std::string& file) {
  return Finder(header, options, file).find();
}

void throw_with_columns_if_unscaled(const InputError& error, const CsvHeader& header, const std::string& format) {
  const auto concerns = [&](const char* option) {
    return std::find(error.options().begin(), error.options().end(), option) != error.options().end();
  };
  if (!concerns("accel_sensitivity") || !concerns("accel_scale")) return;
  AmbiguousColumns listed(error, header);
  listed.format = format;
  listed.roles_known = true;
  throw listed;
}

const ChannelSetup* setup_of(const CsvColumn& column, const ReadOptions& options) {
  for (const auto& entry : options.setup) {
    if (is_named(column, entry.name)) return &entry;
  }
  for (const auto& entry : options.setup) {
    if (is_number_of(column, entry.name)) return &entry;
  }
  return nullptr;
}

bool is_called(const CsvColumn& column, const std::string& name) {
  return is_named(column, name) || is_number_of(column, name);
}

bool is_helper(const CsvColumn& column, const CsvColumns& columns) {
  const auto is = [&](const std::optional<CsvColumn>& other) { return other && other->index == column.index; };
  return is(columns.time) || is(columns.hit) || is(columns.point) || is(columns.run);
}

bool may_be_time(const CsvColumn& column, const CsvColumns& columns) {
  const auto is = [&](const CsvColumn& other) { return other.index == column.index; };
  if (column.index != 0 || !column.has_numbers || quantity_of(column)) return false;
  if ((columns.has_force && is(columns.force)) || is_helper(column, columns)) return false;
  return std::none_of(columns.accel.begin(), columns.accel.end(), is) &&
         !is_one_of(lower_case(column.base), kCountWords);
}

}  // namespace percuss::acquire
