#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.hpp"
#include "pipeline/live/session.hpp"

namespace percuss::pipeline {
namespace {

using Kind = SessionEvent::Kind;

struct KindName {
  Kind kind;
  std::string_view name;
};

constexpr auto kKinds = std::to_array<KindName>({
    {Kind::blow, "blow"},
    {Kind::regraded, "regraded"},
    {Kind::undo, "undo"},
    {Kind::redo, "redo"},
    {Kind::next, "next"},
    {Kind::go_to, "go_to"},
    {Kind::pause, "pause"},
    {Kind::finish, "finish"},
    {Kind::enough, "enough"},
});

}  // namespace

std::string json_of(const SessionEvent& event) {
  nlohmann::ordered_json out{{"event", kKinds.at(static_cast<std::size_t>(event.kind)).name}, {"frame", event.frame}};
  if (event.kind == Kind::blow || event.kind == Kind::go_to || event.kind == Kind::redo) out["point"] = event.point;
  if (event.kind == Kind::regraded) out["row"] = event.row;
  if (event.kind == Kind::blow || event.kind == Kind::regraded) out["mark"] = acquire::name_of(event.mark);
  if (event.kind == Kind::blow) {
    out["message"] = event.message;
    out["peak_n"] = event.peak_N;
    out["bandwidth_hz"] = event.bandwidth_Hz;
    if (event.differ) out["differ"] = *event.differ;
  }
  return out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

SessionEvent parse_session_event(const std::string& json, const std::string& where) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(problem, where, "the journal is damaged; record the session again");
  };
  try {
    const auto in = nlohmann::json::parse(json);
    if (!in.at("frame").is_number_unsigned()) refuse("an event without a frame");
    SessionEvent event{.frame = in["frame"].get<std::uint64_t>()};
    const auto name = in.at("event").get<std::string>();
    const auto* known = std::find_if(kKinds.begin(), kKinds.end(), [&](const KindName& k) { return k.name == name; });
    if (known == kKinds.end()) refuse(fmt::format("unknown event '{}'", one_line(name, 40)));
    event.kind = known->kind;
    event.point = in.value("point", 0);
    event.row = in.value("row", std::size_t{0});
    const auto mark = acquire::row_mark_named(in.value("mark", "none"));
    if (!mark) refuse("unknown reason of a rejection");
    event.mark = mark.value_or(acquire::RowMark::none);
    event.message = in.value("message", "");
    event.peak_N = in.value("peak_n", 0.0);
    event.bandwidth_Hz = in.value("bandwidth_hz", 0.0);
    if (in.contains("differ")) event.differ = in["differ"].get<bool>();
    return event;
  } catch (const nlohmann::json::exception&) {
    refuse("an event that is not readable");
  }
  return {};
}

}  // namespace percuss::pipeline
