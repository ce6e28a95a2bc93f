#include "batch/row_writer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "acquire/format_registry.hpp"
#include "acquire/formats/hdf5/hdf5_output.hpp"
#include "acquire/formats/hdf5/write_frf_hdf5.hpp"
#include "acquire/record/file_format.hpp"
#include "batch/serialized_frf.hpp"
#include "batch/sha256_file.hpp"
#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "metrics/study/batch_columns.hpp"

namespace percuss::batch {
namespace {

using Json = nlohmann::ordered_json;

// Calls use(values of the row). Values of a wrong kind are an InputError.
template <class Use>
void with_row(std::string_view row, const std::string& where, Use&& use) {
  constexpr int kRowDepth = 2;
  try {
    const Json json = nests_deeper_than(row, kRowDepth) ? Json() : Json::parse(row.begin(), row.end());
    if (json.is_object()) return use(json);
  } catch (const Json::exception&) {
  }
  throw InputError("this is not a row", where, "run the shard again", {"batch.run.force"});
}

class JsonLines : public RowWriter {
 public:
  JsonLines(const std::string& path, const BatchTotals& totals, bool force) : file_(path, force) {
    file_.add(batch_header_line(totals));
  }
  void add(std::string_view row, const std::string& /*where*/) override {
    if (row.starts_with(kFrfRow)) return;
    file_.add(row);
    file_.add("\n");
  }
  void commit() override { file_.commit(); }

 private:
  Sha256File file_;
};

std::string cell_of(const Json& value, CsvFormulas formulas) {
  if (value.is_null()) return "";
  if (value.is_string()) return csv_cell(value.get<std::string>(), formulas);
  if (!value.is_array()) return value.dump();
  std::string words;
  for (const Json& one : value) words += (words.empty() ? "" : " ") + one.get<std::string>();
  return csv_cell(words, formulas);
}

class CsvTable : public RowWriter {
 public:
  CsvTable(const std::string& path, bool force, CsvFormulas formulas) : file_(path, force), formulas_(formulas) {
    for (const std::string& column : metrics::batch_columns()) file_.add((column == "row" ? "" : ",") + column);
    file_.add("\n");
  }
  void add(std::string_view row, const std::string& where) override {
    if (row.starts_with(kFrfRow)) return;
    with_row(row, where, [&](const Json& json) {
      std::string line;
      for (const std::string& column : metrics::batch_columns()) {
        const auto value = json.find(column);
        if (column != "row") line += ',';
        if (value != json.end()) line += cell_of(*value, formulas_);
      }
      file_.add(line + "\n");
    });
  }
  void commit() override { file_.commit(); }

 private:
  Sha256File file_;
  CsvFormulas formulas_;
};

// A group name for an id: a slash would make two groups.
std::string group_name(const std::string& id) {
  std::string name;
  for (const char c : id) name += c == '/' ? std::string("%2F") : c == '%' ? std::string("%25") : std::string(1, c);
  return name == "." ? "%2E" : name;
}

class FrfFile : public RowWriter {
 public:
  FrfFile(const std::string& path, const BatchTotals& totals, bool force) : out_(path, force) {
    out_.set_text("", "schema", "percuss/batch-frf/1");
    out_.set_text("", "version", totals.version);
    out_.set_text("", "options_sha256", options_sha256(totals.head));
  }
  void add(std::string_view row, const std::string& where) override {
    if (!row.starts_with(kFrfRow)) return;
    with_row(row, where, [&](const Json& json) {
      const std::string id = json.at("id").get<std::string>(), path = json.at("path").get<std::string>();
      const std::string group = fmt::format("{}/run-{}", group_name(id), json.at("run").get<int>());
      acquire::write_frf_group(out_, group, deserialize_frfs(json.at("packed").get<std::string>(), where),
                               acquire::FrfKind::accelerance);
      out_.set_text(group, "id", id);
      out_.set_text(group, "path", path);
      out_.close_sets();
    });
  }
  void commit() override { out_.commit(); }

 private:
  acquire::hdf5::OutputHdf5 out_;
};

}  // namespace

std::string batch_header_line(const BatchTotals& totals) {
  Json json{{"schema", metrics::kBatchSchema},
            {"version", totals.version},
            {"records", totals.records},
            {"failed", totals.failed},
            {"options", totals.head.options}};
  if (!totals.head.setup.empty()) json["setup"] = totals.head.setup;
  json["options_sha256"] = options_sha256(totals.head);
  return json.dump() + "\n";
}

std::unique_ptr<RowWriter> row_writer(const std::string& path, const BatchTotals& totals, bool force,
                                      CsvFormulas formulas) {
  const std::string extension = acquire::file_extension(path);
  if (extension == ".csv") return std::make_unique<CsvTable>(path, force, formulas);
  if (!acquire::writes_hdf5(path)) return std::make_unique<JsonLines>(path, totals, force);
  if (totals.head.frf) return std::make_unique<FrfFile>(path, totals, force);
  throw InputError("the batch was planned without FRFs", path, "plan the batch with FRFs", {"batch.plan.frf"});
}

}  // namespace percuss::batch
