#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "page_sections.hpp"
#include "tables.hpp"

namespace percuss::accuracy {
namespace {

const Case& main_case(const Family& family, const char* value) { return case_of(family, "noise", value); }

std::string times_bound(const Figure& figure) { return shown_figure(figure.over_bound); }

std::string picture(const Family& family) {
  return fmt::format("![{}: error against time](accuracy-{}.svg)\n", family.title, family.name);
}

// How often a method is beaten, over how many cases.
std::string beaten(const Family& family, const std::string& method) {
  std::size_t all = 0, lost = 0;
  for (const Sweep& sweep : family.sweeps) {
    for (const Case& one : sweep.cases) {
      for (const Figure& figure : one.figures) {
        if (figure.method != method) continue;
        ++all;
        lost += figure.on_pareto_front ? 0 : 1;
      }
    }
  }
  return fmt::format("{} of {}", lost, all);
}

// The least and the largest error over the bound of a method, of all cases of a sweep.
std::string range_over_bound(const Family& family, const std::string& over, const std::string& method) {
  double least = 1e99, most = 0;
  for (const Sweep& sweep : family.sweeps) {
    if (sweep.over != over) continue;
    for (const Case& one : sweep.cases) {
      least = std::min(least, figure_of(one, method).over_bound);
      most = std::max(most, figure_of(one, method).over_bound);
    }
  }
  return fmt::format("{} to {}", shown_figure(least), shown_figure(most));
}

// Where the stated intervals hold the truth least often: "quick and 30 modes, 86.7 %".
std::string least_covered(const Family& family) {
  double least = 1e99;
  std::string where;
  for (const Sweep& sweep : family.sweeps) {
    for (const Case& one : sweep.cases) {
      for (const Figure& figure : one.figures) {
        const double covered = std::strtod(figure.more.at(2).c_str(), nullptr);
        if (covered >= least) continue;
        least = covered;
        where = fmt::format("`{}` ({}: {}), in {} %", figure.method, sweep.over, one.value, figure.more.at(2));
      }
    }
  }
  return where;
}

std::string opening(const Measured& measured, const std::string& build_description) {
  return fmt::format(R"(# Accuracy and speed

How do you know that percuss's figures are right, and what does it cost to have them? This page is the answer, and one command makes it anew, tables, charts and
every number in its sentences:

```
build/release/bench/percuss_accuracy docs/project
```

Measured with {}.

## In short

{}
"Over the bound" is the RMS error over the Cramér–Rao bound, which no unbiased method can beat: 1 is as good as can be. "Time" is a multiple of what cannot be
avoided: reading the file's bytes, and one bare FFTW transform per channel and hit.

## How it was measured

- **Truth.** The records are made (`percuss synth`), from closed forms, so that frequencies, damping ratios, residues, FRFs and deflections are known exactly. Force and response
  pass one and the same anti-alias filter; then noise is added. The methods that are measured have no part in it.
- **Error.** The RMS over all noisy runs, modes and channels: 64 runs in the main case, 16 in the others. Over six modes an RMS from so many runs is itself known to
  4 and to 7 %.
- **Bound.** From the Fisher information of the exact signals, for somebody who knows the force: [theory.md](theory.md), (4.16).
- **Time.** From an HDF5 file in the page cache to the result, on one thread, as processor time, so that other work on the machine matters little. All methods and the bare limit
  take turns in the same run, in a changing order, and the best time of each counts. The limit's transforms are planned by measuring and stay in the cache: it is a hard limit. ([decisions.md](decisions.md), 30,
  compares with transforms of records in memory, a softer one.)
- **Beaten by none.** Nothing else in the same case is as near to the truth and as fast, and better in one of the two. Times within a tenth and errors within a hundredth count as
  the same. In the charts a line joins what nothing beats (Pareto's front).
)",
                     build_description, short_table(measured));
}

std::string frf_part(const Family& family) {
  const Case& main = main_case(family, "1 %");
  return fmt::format(R"(
## Frequency responses

The main case: the bundled composite bat (six modes between 182 and 2650 Hz, two of them 12 Hz apart), two accelerometers, five hits of one second at 25.6 kHz, 1 % of noise on the
accelerations, an exact force; lines from 60 to 3200 Hz. The error is that of all lines together, over the RMS of the exact FRF. The bound is that of a line taken by itself.

{}
{}
H1 meets the bound of a line by itself ({}) wherever the record holds the whole decay. Where it does not, the FRF lacks what came after the record's end: {} times the bound with
0.125 s of record, of which the error is nearly all leakage. `percuss frf` shows the FRF as it is; the modes below are fitted with the missing part allowed for, and do not suffer.

H2 is beaten in {} cases, and never nearer than H1 here, because percuss takes the force as its pulse, which leaves hardly any noise of the force for it to be
unbiased by. It stays for comparison with results that were made with it, and because a gap between H1 and H2 tells of noise that nobody expected. Hv is as near as H1 and costs the same; it
stays for the same reason.
)",
                     case_table(family, main), picture(family), times_bound(figure_of(main, "H1")),
                     times_bound(figure_of(case_of(family, "record length", "0.125 s"), "H1")), beaten(family, "H2"));
}

std::string modes_part(const Family& family) {
  const Case& main = main_case(family, "1 %");
  const Case& noisy = case_of(family, "noise of the force", "0.1 %");
  const Figure &quick = figure_of(main, "quick"), &standard = figure_of(main, "standard"),
               &best = figure_of(main, "best");
  return fmt::format(R"(
## Modes

The same records; from the file to modes with names and error bars. Records with other numbers of modes and channels are of a plainer structure: modes spread over 150 to 3000 Hz, three hits of
one second at 8192 Hz. "95 % intervals right" counts the stated intervals of frequency and damping that hold the truth; "besides" are modes that are not there.

{}
{}
- `best`, the default, comes to {} times the bound in frequency and {} times in damping. From the shortest record to the longest it stays at {} times: a record that
  ends before the decay does costs what it lacks, not more.
- `standard` ({}) and `quick` ({}) fit each mode over its own lines, with a free phase of its residue and a free background: the phase alone costs a factor of 1.4 to 2, the
  background the rest. `quick` takes fewer lines, and does not search for modes that show no peak. They stay because each is faster than what is nearer
  to the truth: `quick` is beaten in {} cases, `standard` in {}.
- The bound is for a known force. A hammer with 0.1 % of noise cannot be known so well: `best` then comes to {} times it, and its error bars say so.
- Error bars: stated intervals of 95 % hold the truth least often with {}.
)",
                     case_table(family, main), picture(family), times_bound(best), best.more.at(1),
                     range_over_bound(family, "record length", "best"), times_bound(standard), times_bound(quick),
                     beaten(family, "quick"), beaten(family, "standard"), times_bound(figure_of(noisy, "best")),
                     least_covered(family));
}

std::string deflection_part(const Family& family) {
  const Case& main = main_case(family, "0.1 %");
  const Case& clean = case_of(family, "noise", "0.01 %");
  const Figure &drift_free = figure_of(main, "drift-free"), &modal = figure_of(main, "modal");
  return fmt::format(R"(
## Largest deflection

A held beam (14.5, 90 and 322 Hz) struck for 2.5 ms, three hits of 1.2 s at 10 kHz with 0.1 s of rest before each; noise of 0.1 % of the RMS acceleration, a bias of 0.3 m/s² and a drift of
0.1 m/s³. Truth is the integral of the pulse against each mode's closed form. From the file to deflections, modes included where `modal` needs them.

{}
{}
- The bound is for somebody who knows the force and how many modes there are, though not their parameters, nor bias and drift. `drift-free` ({}) uses neither force nor modes: that
  is the price of assuming nothing. `modal` ({}) uses both.
- With less noise neither gets nearer than 0.003 %: the largest deflection is told at a sample, and the true one lies between two. The stated deviation does not count that, so that with
  0.01 % of noise `drift-free` is right in only {} % of the intervals of 95 %. `modal` states too much ({} % in the main case).
- `small-interval` integrates the bias with everything else, and `frequency` gives up what lies below its lowest line. Both are faster, and worthless for the largest deflection of such records. They stay because published
  results were made with them, and can be compared with nothing else.
)",
                     case_table(family, main), picture(family), times_bound(drift_free), times_bound(modal),
                     figure_of(clean, "drift-free").more.front(), modal.more.front());
}

std::string impact_part(const Family& family) {
  const Case& main = case_of(family, "step", "10 modes");
  return fmt::format(R"(
## Ball on a beam

`percuss model impact` by both methods, over the step (0.25 to 64 µs) and over the number of modes; the ball and the cricket bat are the defaults. There is no noise, and so no bound. Truth is
another way to the same end: Runge and Kutta's eighth-order method (GSL's `rk8pd`) on the equations of the ball and the same modes, held to 1e-14. Times are multiples of one bare transform of 65 536 values.

{}
{}
`modal` moves the modes exactly between pushes of the contact force, to fourth order in the step; left to itself it chooses a step with which the restitution settles to 1e-9. The
source's `small-increment` holds the force over each step and is of first order. It is the faster one only where an error of a hundredth will do: its longest steps are on the front, its shorter
ones are beaten by `modal` with long ones ({} in all). It stays because the source's figures were made with it.
)",
                     case_table(family, main), picture(family), beaten(family, "small-increment"));
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
  for (const Family* family : {&measured.records.frfs, &measured.records.modes, &measured.deflection, &measured.impact})
    page += all_figures(*family) + "\n";
  return page + all_scaling(measured.scalings);
}

}  // namespace percuss::accuracy
