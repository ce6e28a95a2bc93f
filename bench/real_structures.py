#!/usr/bin/env python3
"""real_structures.py [--data FOLDER] [--measured FOLDER] [--outcomes JSON] [--percuss TOOL] DOCS

Measures percuss on measured structures and counts the outcomes of simulated imperfect tests. Rewrites the section "On
real structures" of DOCS/accuracy.md and the section "Imperfect tests" of DOCS/stress.md; the other sections stay. The
ordinary build and the other documents need none of these data.

  --data      folder with a folder per measured set: independent.json (reference modes), and its record where
              the licence permits a copy
  --measured  folder with the sets that come from public repositories: violin_back, spruce_plates (CSV)
  --outcomes  outcomes of the imperfect tests: JSON, a list of {scenario, level, seed, outcome}; the tests and
              their scorer are not part of this repository
  --percuss   the tool (default: build/release/tools/percuss)
"""
import argparse
import collections
import glob
import json
import os
import re
import statistics
import subprocess
import tempfile

NEAR = 0.01  # relative distance from a reference frequency within which a mode counts as found
CSV = ['--fs', '48000', '--unit', 'g', '--force-unit', 'N', '--quiet']
ABOUT_MEASURED = """\
`bench/real_structures.py` measures this section. The reference modes come from independent fits; they are another
estimate, not the truth. "Over σ" is the scatter of a mode's single hits, divided by their stated standard deviations:
the median over the modes, and the share of modes below 3. "Halves" compares the modes of the even points with the modes
of the odd points: the differences of the frequencies, divided by their σ.
"""
ABOUT_SIMULATED = """\
Simulated tests with one imperfection each. [stress.md](stress.md#imperfect-tests) defines the outcomes. Named: results
are wrong, and a message says why. Warned: results are wrong, and a message says that they may be. SILENT: results are
wrong without a message. UNNAMED: results are right or fair, their standard deviations are unreliable, and no message
says why.
"""
ABOUT_SCENARIOS = """\
Each scenario is a hammer test of a tube with one imperfection of real tests, simulated at 16 times the sampling rate
and independently of percuss. A true mode is clear if it lies in the band and the Cramér–Rao bound on its damping ratio
is at most 5 % of the ratio. The results of a test are wrong in one of these cases:

- a mode is more than 5 of its stated standard deviations from the truth;
- a clear mode is missing, and `unclaimed_peaks` names no place near it (one mode may stand for several that no method
  can tell apart);
- a mode is false, or a wrong type is stated with a confidence of 0.9 or more;
- residues are wrong by more than 5 standard deviations and 2 %, in scenarios that test them.

Each test has one outcome:

- right: results are not wrong, and all modes are within 3 of their stated standard deviations; fair: within 5
- UNNAMED: the test would be right or fair, but the imperfection makes the standard deviations unreliable, and no
  message names it
- named: results are wrong, and a message names the imperfection; warned: results are wrong, and a message says that
  they may be; SILENT: results are wrong, and there is no such message
- refused: percuss gives no modes
- other: nothing in the record shows the imperfection, so no result is required; or good hits were rejected

The scenario twenty is either right or SILENT. It is right if no clear mode is missing, no mode is false, no value is
more than 5 standard deviations from the truth, and the mean of the squared distances from the truth, each divided by
its variance, is at most 1.5.

A row states a scenario and its level: a higher level is a larger imperfection, or another form of it. Explanations of
some names:

- damper, gyro: complex modes, from a damper at one place or from gyroscopic coupling; air: damping rises with amplitude
- drift_hits, drift_decay: frequencies drift from hit to hit, or during the decay
- late_trigger, late_all: rows that begin within the pulse, for two hits or for all; begins_after: rows without the
  pulse
- rebound: the hammer comes back after 18 ms; tail: a long soft end of the pulse; off_axis: hits at an angle
- coupling, overload_droop: the high-pass of the sensors' supply, without and with clipping of the force
- skew: channels sampled one after the other; late_sensors, early_sensors: all sensors late or early against the force
- light, heavy: low and high damping
- mounting: a resonance of the second sensor's mounting; steps: coarse quantisation; lost: samples missing in all
  channels
- machine: vibration of a machine nearby; crowded: 60 modes that overlap; repeated: nearly repeated roots; outside:
  strong modes just outside the band
- stop: contact with a stop at large amplitude; impatient: the next hit comes before the decay has ended
- sloppy: a recorder with a first-order filter only; filters: different filters for hammer and sensors; thinned: a lower
  sampling rate without a filter
- twenty: twenty tests of one structure; ordinary: a little of many imperfections

`bench/real_structures.py` writes this section.
"""
OUTCOMES = ['right', 'fair', 'named', 'warned', 'refused', 'UNNAMED', 'SILENT']


def percuss(tool, *words):
    """The JSON document of a command; None if the command refused its input."""
    result = subprocess.run([tool, *words, '--json'], capture_output=True, text=True, check=False)
    return json.loads(result.stdout) if result.stdout.startswith('{') else None


def frequencies(reference):
    """The reference frequencies in any of the forms of independent.json."""
    return [m[0] if isinstance(m, list) else m.get('f_sdof') or m['f_lscf'] for m in reference]


def found(modes, reference):
    """The number of reference modes that have a mode of their own, and the number of the other modes."""
    left = sorted(m['frequency_hz'] for m in modes)
    count = 0
    for hz in reference:
        best = min(left, key=lambda f: abs(f - hz), default=None)
        if best is not None and abs(best - hz) <= NEAR * hz:
            left.remove(best)
            count += 1
    return count, len(left)


def scatter(document):
    """Per mode, the rms of the deviations of single hits from their mean, over their standard deviations."""
    of_mode = collections.defaultdict(list)
    for one in document.get('modes_per_hit', []):
        of_mode[one['mode']].append(one)
    out = {'frequency_hz': [], 'damping_ratio': []}
    for hits in of_mode.values():
        for key, values in out.items():
            x = [h[key] for h in hits]
            s = [h[key.replace('_hz', '_std_hz') if '_hz' in key else key + '_std'] for h in hits]
            if len(x) > 2 and min(s) > 0:
                squares = sum(((v - statistics.fmean(x)) / d) ** 2 for v, d in zip(x, s))
                values.append((squares / (len(x) - 1)) ** 0.5)
    return out


def pairs(one, other):
    """|z| of each mode of one half of a test and the nearest mode of the other half."""
    z = []
    for m in one['modes']:
        n = min(other['modes'], key=lambda k: abs(k['frequency_hz'] - m['frequency_hz']), default=None)
        if n is None or abs(n['frequency_hz'] - m['frequency_hz']) > NEAR * m['frequency_hz']:
            continue
        std = (m['frequency_std_hz'] ** 2 + n['frequency_std_hz'] ** 2) ** 0.5
        z.append(abs(m['frequency_hz'] - n['frequency_hz']) / std)
    return z


def spread(values):
    """The median, and the share of the values below 3."""
    if not values:
        return '–'
    return '%.2g; %.0f %% below 3' % (statistics.median(values), 100 * sum(v < 3 for v in values) / len(values))


def row(name, document, reference, z=(), hits=True):
    """A row of the table of measured sets."""
    if document is None:
        return '| %s | refused | | | | |' % name
    count, beyond = found(document['modes'], reference)
    modes = '%d of %d; %d more' % (count, len(reference), beyond) if reference else 'no reference; %d found' % beyond
    every = document.get('hits', [])
    used = '%d of %d' % (sum(h['accepted'] for h in every), len(every)) if hits and every else '–'
    s = scatter(document)
    return '| %s | %s | %s | %s | %s | %s |' % (name, modes, used, spread(s['frequency_hz']), spread(s['damping_ratio']),
                                              spread(list(z)))


def survey_of_points(tool, folder, work):
    """Joins the hits of each point of the violin's back plate into one record. Surveys all points, and two halves of
    the points."""
    points = collections.defaultdict(list)
    for path in sorted(glob.glob(os.path.join(folder, '*_acq_*.csv'))):
        points[path.rsplit('_acq_', 1)[0]].append(path)
    files = []
    for number, hits in enumerate(points.values()):
        files.append(os.path.join(work, 'p%02d.h5' % number))
        subprocess.run([tool, 'convert', *hits, *CSV, '--files', 'hits', '-o', files[-1]], check=True)
    band = ['--band', '100:1500', '--quiet']
    return [percuss(tool, 'survey', *some, *band) for some in (files, files[::2], files[1::2])]


def halves_of_frfs(tool, options, work):
    """Writes the FRFs of a survey to two tables, of the even and of the odd points."""
    table = subprocess.run([tool, 'frf', *options, '--quiet'], capture_output=True, text=True, check=True).stdout
    kind, *rows = table.splitlines()
    rows = [line.split(',') for line in rows]
    point = [0] + [int(re.match(r'p(\d+)_', name).group(1)) for name in rows[0][1:]]
    paths = [os.path.join(work, name) for name in ('even.csv', 'odd.csv')]
    for half, path in enumerate(paths):
        columns = [0] + [c for c in range(1, len(point)) if point[c] % 2 == half]
        with open(path, 'w', encoding='utf-8') as out:
            out.write('\n'.join([kind] + [','.join(line[c] for c in columns) for line in rows]) + '\n')
    return paths


def measured_rows(tool, data, measured):
    """One row per measured set."""
    reference = {name: json.load(open(os.path.join(data, name, 'independent.json'), encoding='utf-8'))
                 for name in ('violin_back', 'spruce_plates', 'pyfrf_5hits', 'modelab_beam', 'plate_9x9')}
    rows = []
    with tempfile.TemporaryDirectory() as work:
        whole, even, odd = survey_of_points(tool, os.path.join(measured, 'violin_back'), work)
        halves = pairs(even, odd) if even and odd else []
        rows.append(row('violin back, 27 points', whole, reference['violin_back']['published_hz'], halves))
    for plate in range(1, 6):
        files = sorted(glob.glob(os.path.join(measured, 'spruce_plates', 'plate_%d_*.csv' % plate)))
        document = percuss(tool, 'analyze', *files, *CSV, '--files', 'hits', '--band', '40:450', '--per-hit')
        known = frequencies(reference['spruce_plates'].get('plate_%d' % plate, []))
        rows.append(row('spruce plate %d' % plate, document, known))
    # The band of the force's spectrum ends below the last reference mode.
    document = percuss(tool, 'analyze', os.path.join(data, 'pyfrf_5hits', 'record.h5'), '--per-hit', '--quiet',
                       '--band', '100:8000')
    rows.append(row('steel part, 5 hits', document, frequencies(reference['pyfrf_5hits']['modes'])))
    beam = sorted(glob.glob(os.path.join(data, 'modelab_beam', 'Hxysv*.txt')))
    tests = [percuss(tool, 'survey', *some, '--quiet') for some in (beam, beam[::2], beam[1::2])]
    z = pairs(tests[1], tests[2]) if tests[1] and tests[2] else []
    rows.append(row('beam, 9 FRFs', tests[0], frequencies(reference['modelab_beam']['modes']), z, hits=False))
    plate = os.path.join(data, 'plate_9x9', '00A_Ref_1.MAT')
    with tempfile.TemporaryDirectory() as work:
        band = ['--band', '20:2200', '--quiet']
        document = percuss(tool, 'survey', plate, '--df', '0.5', *band)
        halves = halves_of_frfs(tool, [plate, '--df', '0.5'], work)
        even, odd = [percuss(tool, 'survey', half, *band) for half in halves]
    z = pairs(even, odd) if even and odd else []
    rows.append(row('plate, 81 FRFs', document, frequencies(reference['plate_9x9']['modes_Ref_1']), z, hits=False))
    return rows


def outcome_of(result):
    return 'refused' if result['outcome'].startswith(('refused', 'no modes')) else result['outcome'].split('?')[0]


def outcome_counts(results):
    count = collections.Counter(outcome_of(r) for r in results)
    return [count[o] for o in OUTCOMES] + [sum(n for o, n in count.items() if o not in OUTCOMES)]


def outcome_table(results, by):
    """Outcomes of the imperfect tests, a row per value of `by`."""
    groups = collections.defaultdict(list)
    for result in results:
        groups[by(result)].append(result)
    lines = ['| | ' + ' | '.join(OUTCOMES) + ' | other |', '|---|' + '---:|' * (len(OUTCOMES) + 1)]
    lines += ['| %s | %s |' % (name, ' | '.join(str(n or '') for n in outcome_counts(some)))
              for name, some in groups.items()]
    return '\n'.join(lines)


def replace_section(path, heading, body, before=None):
    """Replaces a section. Without an old one, writes it before the heading `before`, or at the end."""
    with open(path, encoding='utf-8') as page:
        text = page.read()
    section = '## %s\n\n%s\n' % (heading, body)
    old = re.search(r'^## %s\n.*?(?=^## |\Z)' % re.escape(heading), text, re.S | re.M)
    if old:
        text = text[:old.start()] + section + ('\n' if old.end() < len(text) else '') + text[old.end():]
    elif before:
        text = text.replace('## %s\n' % before, section + '\n## %s\n' % before, 1)
    else:
        text = text.rstrip('\n') + '\n\n' + section
    with open(path, 'w', encoding='utf-8') as page:
        page.write(text)


def accuracy_section(rows, results):
    text = [ABOUT_MEASURED]
    if rows:
        heads = ['measured set', 'reference modes found', 'hits used', 'frequency over σ', 'damping over σ',
                 'halves over σ']
        text.append('| ' + ' | '.join(heads) + ' |\n' + '|---' * len(heads) + '|\n' + '\n'.join(rows) + '\n')
    if results:
        text.append(ABOUT_SIMULATED)
        text.append(outcome_table(results, lambda r: 'all tests') + '\n')
    return '\n'.join(text).rstrip('\n')


def stress_section(results):
    return ABOUT_SCENARIOS + '\n' + outcome_table(results, lambda r: '%s %s' % (r['scenario'], r['level']))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument('docs')
    options.add_argument('--data')
    options.add_argument('--measured')
    options.add_argument('--outcomes')
    options.add_argument('--percuss', default='build/release/tools/percuss')
    given = options.parse_args()
    rows = measured_rows(given.percuss, given.data, given.measured) if given.data and given.measured else []
    results = json.load(open(given.outcomes, encoding='utf-8')) if given.outcomes else []
    if rows or results:
        replace_section(os.path.join(given.docs, 'accuracy.md'), 'On real structures', accuracy_section(rows, results))
    if results:
        replace_section(os.path.join(given.docs, 'stress.md'), 'Imperfect tests', stress_section(results), 'Measured')


if __name__ == '__main__':
    main()
