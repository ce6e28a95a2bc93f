#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>

#include "bindings.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "numpy_views.hpp"
#include "option_names.hpp"

namespace percuss::python {
namespace {

namespace py = pybind11;

py::object optional_view(std::span<const double> values, const std::shared_ptr<const void>& owner) {
  return values.empty() ? py::object(py::none()) : py::object(view_of(values, owner));
}

// The analysed band; the fits also use spectral lines outside it.
acquire::LineRange band_of(const pipeline::Analysis& analysis) {
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  return frf::lines_in_band(analysis.lines().fs_Hz, analysis.lines().samples, low_Hz, high_Hz);
}

py::array frequencies_of(const SharedResult& held, std::size_t test) {
  const pipeline::Analysis& analysis = *analysis_of(held, test);
  const std::vector<double> freq_Hz = freq_Hz_of(without_gil(held, [&] { return band_of(analysis); }));
  return copy_of(std::span<const double>(freq_Hz));
}

// Views of the FRFs of the analysis; copies for another kind.
py::list frfs_of(const SharedResult& held, std::size_t test, const std::string& kind) {
  const auto analysis = analysis_of(held, test);
  const auto& frfs = without_gil(
      held, [&]() -> const auto& { return analysis->frfs(); });
  const acquire::LineRange band = without_gil(held, [&] { return band_of(*analysis); });
  const std::size_t first = band.first - analysis->lines().first;
  if (kind == name_of(acquire::FrfKind::accelerance)) return responses_of(frfs, first, band.count, analysis);
  const acquire::FrfKind wanted =
      kind == name_of(acquire::FrfKind::mobility) ? acquire::FrfKind::mobility : acquire::FrfKind::receptance;
  auto made = std::make_shared<std::vector<acquire::PointFrf>>(frfs);
  for (acquire::PointFrf& one : *made)
    one.frf = acquire::converted(one.frf, analysis->lines(), wanted, analysis->window_decay_per_s());
  return responses_of(*made, first, band.count, made);
}

// Columns [modes] of the modal parameters, and residues [modes][FRF channels].
py::dict modes_of(const SharedResult& held, std::size_t test) {
  const pipeline::Analysis& analysis = *analysis_of(held, test);
  const auto modes = without_gil(held, [&] { return analysis.modes(); });
  const std::size_t frf_channels = modes.empty() ? 0 : modes.front().residues.size();
  const auto column = [&](const auto& number) {
    std::vector<double> values;
    values.reserve(modes.size());
    for (const identify::Mode& mode : modes) values.push_back(number(mode));
    return copy_of(std::span<const double>(values));
  };
  py::array_t<Complex> residues({modes.size(), frf_channels});
  py::array_t<double> residue_std({modes.size(), frf_channels});
  py::list places;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (std::size_t c = 0; c < frf_channels; ++c) {
      const identify::Residue& residue = modes[m].residues.at(c);
      residues.mutable_at(m, c) = residue.value;
      residue_std.mutable_at(m, c) =
          std::hypot(residue.std, residue.relative_std * std::abs(residue.value));  // as the document
      if (m == 0) places.append(py::make_tuple(residue.point, residue.channel));
    }
  }
  py::dict out;
  out["frequency_hz"] = column([](const identify::Mode& m) { return m.pole.freq_Hz; });
  out["frequency_std_hz"] = column([](const identify::Mode& m) { return m.freq_std_Hz; });
  out["damping_ratio"] = column([](const identify::Mode& m) { return m.pole.damping_ratio; });
  out["damping_ratio_std"] = column([](const identify::Mode& m) { return m.damping_std; });
  out["residues"] = read_only(residues);
  out["residues_std"] = read_only(residue_std);
  out["places"] = places;
  return out;
}

// [(hit, channel, point, first_s, velocity, deflection, std or None)]
py::list deflections_of(const SharedResult& held) {
  const auto& test = held->outcome.deflection;
  if (!test) throw py::type_error("the result has no deflection");
  py::list out;
  for (const pipeline::DeflectedHit& hit : test->hits) {
    const auto view = [&](const std::vector<double>& values) { return view_of(std::span<const double>(values), test); };
    out.append(py::make_tuple(hit.hit, hit.channel, hit.point, hit.first_s, view(hit.deflection.velocity_mps),
                              view(hit.deflection.deflection_m), optional_view(hit.deflection.std_m, test)));
  }
  return out;
}

py::dict columns_of(const SharedResult& held) {
  py::dict out;
  for (const report::NumericColumn& column : held->outcome.columns)
    out[py::str(column.name)] = view_of(std::span<const double>(column.values), held);
  for (const report::WordColumn& column : held->outcome.words) {
    const py::object words = py::module_::import("numpy").attr("array")(py::cast(column.values));
    words.attr("setflags")(py::arg("write") = false);
    out[py::str(column.name)] = words;
  }
  return out;
}

py::object record_of(const SharedResult& held) {
  const auto& test = held->outcome.synthetic;
  if (!test) return py::none();
  return py::cast(std::make_shared<RecordHandle>(RecordHandle{.record = test->record}));
}

py::list opened_of(const SharedResult& held) {
  py::list out;
  for (const auto& one : held->outcome.opened) {
    if (const auto* record = std::get_if<acquire::Record>(&one)) {
      out.append(std::make_shared<RecordHandle>(RecordHandle{.record = *record}));
    } else {
      out.append(std::make_shared<acquire::FrfRecord>(std::get<acquire::FrfRecord>(one)));
    }
  }
  return out;
}

// A .json file holds the document, which does not need the arrays any more.
void require_same_arrays(const ResultHandle& held, const std::string& path) {
  if (tools::extension_of(path) == ".json") return;
  for (const auto& [test, sum] : held.arrays) {
    if (sample_checksum(*test) != sum)
      throw InputError("the arrays have changed since the analysis", "save", "save earlier, or analyze them again");
  }
}

}  // namespace

const std::shared_ptr<const pipeline::Analysis>& analysis_of(const SharedResult& held, std::size_t test) {
  const auto& all = held->outcome.analyses;
  if (all.empty())
    throw InputError("the result holds no FRFs", "analysis without a force", "analyse a record with a force",
                     {"force_channel"});
  if (test >= all.size()) throw py::index_error("test " + std::to_string(test) + " of " + std::to_string(all.size()));
  return all[test];
}

std::vector<double> freq_Hz_of(const acquire::LineRange& lines) {
  std::vector<double> freq_Hz(lines.count);
  for (std::size_t i = 0; i < lines.count; ++i) freq_Hz[i] = lines.freq_Hz(i);
  return freq_Hz;
}

py::list responses_of(const std::vector<acquire::PointFrf>& frfs, std::size_t first, std::size_t count,
                      const std::shared_ptr<const void>& owner) {
  const auto within = [&](const auto& values) {
    return std::span(values).subspan(values.empty() ? 0 : first, values.empty() ? 0 : count);
  };
  py::list out;
  for (const acquire::PointFrf& one : frfs) {
    out.append(py::make_tuple(one.point, one.channel, one.frf.averages, view_of(within(one.frf.value), owner),
                              optional_view(within(one.frf.std), owner),
                              optional_view(within(one.frf.coherence), owner)));
  }
  return out;
}

void bind_outcome(py::module_& module) {
  py::class_<ResultHandle, SharedResult>(module, "CommandResult")
      .def_property_readonly("code", [](const ResultHandle& held) { return held.code; })
      .def_property_readonly("document", [](const ResultHandle& held) { return decoded(held.outcome.document); })
      .def_property_readonly("notes", [](const ResultHandle& held) { return notes_of(held.outcome.notes); })
      .def_property_readonly("tests", [](const ResultHandle& held) { return held.outcome.analyses.size(); })
      .def("text",
           [](const SharedResult& held, std::size_t width) {
             return decoded(
                 held->outcome.text
                     ? without_gil(held, [&] { return visible_text(held->outcome.text(width, option_in_python)); })
                     : std::string());
           })
      .def("html",
           [](const SharedResult& held) {
             return decoded(held->outcome.html ? without_gil(held, [&] { return held->outcome.html(); })
                                               : std::string());
           })
      .def("save",
           [](const SharedResult& held, const std::string& path, bool force) {
             if (!held->outcome.save) throw py::type_error("this result cannot be saved to a file");
             without_gil(held, [&] {
               require_same_arrays(*held, path);
               held->outcome.save(path, force);
             });
           })
      .def("possible",
           [](const SharedResult& held, std::size_t test) {
             const auto analysis = analysis_of(held, test);
             return without_gil(held, [&] { return analysis->possible(); });
           })
      .def("frequency_hz", &frequencies_of)
      .def("frfs", &frfs_of)
      .def("modes", &modes_of)
      .def("stabilisation", &stabilisation_of)
      .def("shapes", &shapes_of)
      .def("deflections", &deflections_of)
      .def("columns", &columns_of)
      .def("record", &record_of)
      .def("opened", &opened_of);
}

}  // namespace percuss::python
