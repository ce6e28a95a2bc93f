#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "page_sections.hpp"
#include "tables.hpp"
#include "wrap_prose.hpp"

namespace percuss::accuracy {
namespace {

constexpr std::size_t kPageWidth = 120;  // characters of prose

const Case& main_case(const TaskFigures& task, const char* value) { return case_of(task, "noise", value); }

std::string times_bound(const Figure& figure) { return shown_figure(figure.over_bound); }

std::string picture(const TaskFigures& task) {
  return fmt::format("![{}: error against time](accuracy-{}.svg)\n", task.title, task.name);
}

// How many of a method's rows, in all cases, are not Pareto-optimal: "17 of 21".
std::string not_optimal(const TaskFigures& task, const std::string& method, const char* of = "of") {
  std::size_t all = 0, count = 0;
  for (const Sweep& sweep : task.sweeps) {
    for (const Case& one : sweep.cases) {
      for (const Figure& figure : one.figures) {
        if (figure.method != method) continue;
        ++all;
        count += figure.on_pareto_front ? 0 : 1;
      }
    }
  }
  return fmt::format("{} {} {}", count, of, all);
}

// The smallest and the largest error over the bound of a method in a sweep.
std::string range_over_bound(const TaskFigures& task, const std::string& over, const std::string& method) {
  double least = 1e99, most = 0;
  for (const Sweep& sweep : task.sweeps) {
    if (sweep.over != over) continue;
    for (const Case& one : sweep.cases) {
      least = std::min(least, figure_of(one, method).over_bound);
      most = std::max(most, figure_of(one, method).over_bound);
    }
  }
  return fmt::format("{} to {}", shown_figure(least), shown_figure(most));
}

// The lowest coverage of the stated intervals: "`quick` (modes: 30 modes), 86.7 %".
std::string least_covered(const TaskFigures& task) {
  double least = 1e99;
  std::string where;
  for (const Sweep& sweep : task.sweeps) {
    for (const Case& one : sweep.cases) {
      for (const Figure& figure : one.figures) {
        const double covered = std::strtod(figure.more.at(2).c_str(), nullptr);
        if (covered >= least) continue;
        least = covered;
        where = fmt::format("`{}` ({}: {}), {} %", figure.method, sweep.over, one.value, figure.more.at(2));
      }
    }
  }
  return where;
}

std::string opening(const Measured& measured, const std::string& build_description) {
  return fmt::format(R"(# Accuracy and speed

How accurate are the results of percuss, and how long do they take? One command measures both and writes this page,
except its last section, with its tables, its charts and the numbers in its sentences:

```
build/release/bench/percuss_accuracy docs/project
```

Measured with {}.

## In short

{}
"Over the bound" is the RMS of the errors, each divided by its own Cramér–Rao bound. No unbiased method can go below 1.
Errors of frequencies and damping ratios are relative to the true value. "Time" is a multiple of the unavoidable work:
reading the bytes of the file, and one bare FFTW transform per channel and hit.

## Method

- **Truth.** `percuss synth` computes the records from closed forms, so frequencies, damping ratios, residues, FRFs and
  deflections are known exactly. Force and response pass the same anti-alias filter; then noise is added. The
  synthesis uses none of the methods under test.
- **Error.** The RMS over all noisy runs, modes and channels: 64 runs in the main case, 16 in the others. With six modes
  the uncertainty of such an RMS is 4 % for 64 runs and 7 % for 16.
- **Bound.** The Cramér–Rao bound follows from the Fisher information of the exact signals, with a known force:
  [theory.md](../theory/theory.md), (4.16).
- **Time.** The processor time on one thread from an HDF5 file in the page cache to the result, so other work on the
  machine matters little. All methods and the baseline alternate in one run, in a changing order, and the best time of
  each counts. The baseline is a hard limit: its transforms are planned by measurement (up to 2^17 samples), and use one
  buffer that stays in the processor's cache. ([decisions.md](decisions.md), 30, compares with transforms of the records
  in memory, which take longer.)
- **Pareto-optimal.** No other method in the same case is at least as accurate and as fast, and better in one of the
  two. Times within a tenth and errors within a hundredth count as equal. In the charts a line joins the Pareto-optimal
  methods.
)",
                     build_description, short_table(measured));
}

std::string frf_part(const TaskFigures& task) {
  const Case& main = main_case(task, "1 %");
  return fmt::format(R"(
## Frequency responses

The main case is the bundled composite bat: six modes between 182 and 2650 Hz, two of them 12 Hz apart. It has two
accelerometers, five hits of one second at 25.6 kHz, 1 % of noise on the accelerations, and an exact force. The lines go
from 60 to 3200 Hz. The error is the RMS over all spectral lines, relative to the RMS of the exact FRF. The bound treats
each line separately.

{}
{}
H1 reaches the bound of single lines ({}) where the record contains the whole decay. A record that ends earlier
truncates the FRF: the error is {} times the bound with 0.125 s of record, and nearly all of it is leakage.
`percuss frf` does not correct the FRF. The fit of the modes below includes the truncation, so it has no such error.

H2 is not Pareto-optimal in {} cases, and is never more accurate than H1 here: percuss uses only the pulse of the force,
so hardly any noise of the force remains. H2 stays for comparison with published results, and because a difference
between H1 and H2 shows unexpected noise. Hv is as accurate as H1 and costs the same; it stays for the same reason.
)",
                     case_table(task, main), picture(task), times_bound(figure_of(main, "H1")),
                     times_bound(figure_of(case_of(task, "record length", "0.125 s"), "H1")), not_optimal(task, "H2"));
}

std::string modes_part(const TaskFigures& task) {
  const Case& main = main_case(task, "1 %");
  const Case& noisy = case_of(task, "noise of the force", "0.1 %");
  const Figure &quick = figure_of(main, "quick"), &standard = figure_of(main, "standard"),
               &best = figure_of(main, "best");
  return fmt::format(R"(
## Modes

The records are the same. The time is from the file to modes with classification and standard deviations. Other numbers
of modes and channels use a simpler structure: modes spread over 150 to 3000 Hz, three hits of one second at 8192 Hz.
"Coverage" is the part of the stated 95 % intervals of frequency and damping that contain the truth. "Spurious" modes do
not exist in the structure.

{}
{}
- `best`, the default, reaches {} times the bound in frequency and {} times in damping. With shorter and longer
  records it stays at {} times. If a record ends before the decay does, only the missing information is lost.
- `standard` ({}) and `quick` ({}) fit each mode over its own lines, with a free phase of its residue and a free
  background. The phase alone costs a factor of 1.4 to 2, and the background the rest. `quick` uses fewer lines, and
  does not search for modes without a peak. Both stay because they are faster than every more accurate method: `quick`
  is not Pareto-optimal in {} cases, `standard` in {}.
- The bound assumes a known force. With 0.1 % of noise on the hammer signal `best` reaches {} times the bound, and its
  stated standard deviations include this.
- The coverage of the stated 95 % intervals is lowest with {}.
)",
                     case_table(task, main), picture(task), times_bound(best), best.more.at(1),
                     range_over_bound(task, "record length", "best"), times_bound(standard), times_bound(quick),
                     not_optimal(task, "quick"), not_optimal(task, "standard"), times_bound(figure_of(noisy, "best")),
                     least_covered(task));
}

std::string deflection_part(const TaskFigures& task) {
  const Case& main = main_case(task, "0.1 %");
  const Case& clean = case_of(task, "noise", "0.01 %");
  const Figure &drift_free = figure_of(main, "drift-free"), &modal = figure_of(main, "modal");
  return fmt::format(R"(
## Largest deflection

The structure is a held beam (14.5, 90 and 322 Hz). It is hit three times: each row has 1.2 s at 10 kHz, with a pulse of
2.5 ms after 0.1 s of rest. The noise is 0.1 % of the RMS acceleration; a bias of 0.3 m/s² and a drift of 0.1 m/s³ are
added. Truth is the convolution of the pulse with the closed form of each mode. The time is from the file to the
deflections. For `modal` it includes the identification of the modes.

{}
{}
- The bound assumes a known force and a known number of modes, but unknown modal parameters, bias and drift.
  `drift-free` ({}) uses neither force nor modes, hence its distance from the bound. `modal` ({}) uses both.
- With less noise the errors of `drift-free` and `modal` stay at 0.003 to 0.004 %: the largest deflection is stated at a
  sample, and the true maximum lies between two samples. The stated standard deviation does not include this: with
  0.01 % of noise the coverage of `drift-free` is only {} %. `modal` states too large a standard deviation (coverage {} %
  in the main case).
- `small-interval` integrates the bias together with the signal, and `frequency` omits all motion below its lowest line.
  Both are faster, but useless for the largest deflection of such records. They stay for comparison with published
  results.
)",
                     case_table(task, main), picture(task), times_bound(drift_free), times_bound(modal),
                     figure_of(clean, "drift-free").more.front(), modal.more.front());
}

std::string impact_part(const TaskFigures& task) {
  const Case& main = case_of(task, "step", "10 modes");
  return fmt::format(R"(
## Ball on a beam

`percuss model impact` runs with both methods, over the step (0.25 to 64 µs) and over the number of modes, with the
default ball and cricket bat. There is no noise, so there is no bound. Truth is an independent solution: an eighth-order
Runge–Kutta method (GSL's `rk8pd`) on the equations of the ball and the same modes, with a tolerance of 1e-14. Times are
multiples of one bare transform of 65 536 values.

{}
{}
`modal` moves the modes exactly between impulses of the contact force and has fourth order in the step. By default it
shortens the step until the estimated error of the restitution and the error of the energy are at most 5e-10. The
published `small-increment` keeps the force constant in each step and has first order. It is faster only for errors of a
hundredth: its longest steps are Pareto-optimal, but not its shorter ones
({} rows are not Pareto-optimal). It stays for comparison with published figures.
)",
                     case_table(task, main), picture(task), not_optimal(task, "small-increment", "of its"));
}

}  // namespace

std::string short_table(const Measured& measured) {
  const Figure& h1 = figure_of(main_case(measured.records.frfs, "1 %"), "H1");
  std::vector<std::vector<std::string>> rows{
      {"FRFs (H1)", shown_figure(h1.error) + " %", times_bound(h1), shown_figure(h1.time_ratio) + " ×"}};
  for (const char* effort : {"quick", "standard", "best"}) {
    const Figure& f = figure_of(main_case(measured.records.modes, "1 %"), effort);
    rows.push_back({fmt::format("modes, `--effort {}`", effort),
                    fmt::format("frequency {} ppm, damping {} %", shown_figure(f.error), f.more.front()),
                    fmt::format("{}, {}", times_bound(f), f.more.at(1)), shown_figure(f.time_ratio) + " ×"});
  }
  const Figure& deflection = figure_of(main_case(measured.deflection, "0.1 %"), "drift-free");
  rows.push_back({"largest deflection (0.1 % of noise)", shown_figure(deflection.error) + " %", times_bound(deflection),
                  shown_figure(deflection.time_ratio) + " ×"});
  return markdown_table({"from records with 1 % of noise", "RMS error", "over the bound", "time"}, rows);
}

std::string page_of(const Measured& measured, const std::string& build_description) {
  std::string page = opening(measured, build_description) + frf_part(measured.records.frfs) +
                     modes_part(measured.records.modes) + deflection_part(measured.deflection) +
                     impact_part(measured.impact) + scaling_section(measured.scalings) +
                     skipped_work_section(measured.savings) + "\n## All figures\n\n";
  for (const TaskFigures* task :
       {&measured.records.frfs, &measured.records.modes, &measured.deflection, &measured.impact})
    page += all_figures(*task) + "\n";
  return wrap_prose(page + all_scaling(measured.scalings), kPageWidth);
}

}  // namespace percuss::accuracy
