"""Source [9]: a ball on a cricket bat."""
from sources.page import Section, signed

PLACES = 'at=0.025:0.065:0.545'
BATS = {'composite': (4000, 1200, 2.24), 'other': (3000, 800, 2.6)}  # EI in N·m², T in N·m/rad, ρA in kg/m

# The test of the source, with the modes of a model beam: a ball strikes nine points, three times each, and an
# accelerometer under the point is the only channel. The pulse has the momentum and the
# duration of the impact in the model.
IMPACT_TEST = r'''cat > impact-test.sh <<'END'
# NAME EI T RHO-A: nine struck points, three blows each, without force; and a hammer test of the same bat
percuss model beam --ei $2 --torsion $3 --rho-a $4 --modes 5 -o $1.beam.csv -o $1.beam.json --quiet > /dev/null
percuss model impact --ei $2 --torsion $3 --rho-a $4 --sweep at=0.025:0.065:0.545 -o $1.sweep.csv --quiet > /dev/null
awk -F, -v bat=$1 -v rho=$4 '
function specification(name, at, width, peak, duration,    m, k, i, text) {
  for (i = 1; x[i + 1] < at; ++i) {}
  k = (at - x[i]) / (x[i + 1] - x[i])
  text = sprintf("{\"fs_hz\": 20000, \"duration_s\": %g, \"band_hz\": [5, 5000], \"hits\": 3, \"pretrigger_s\": 0.1,", duration)
  text = text "\"onset_spread_s\": 0, \"structure\": {\"rigid_line_per_kg\": [0]}, \"modes\": ["
  for (m = 1; m <= 5; ++m) {
    X = (1 - k) * shape[m, i] + k * shape[m, i + 1]
    if (m > 1) text = text ","
    text = text sprintf("{\"frequency_hz\": %.9g, \"damping_ratio\": 0.005, \"family\": \"bending\",", f[m])
    text = text sprintf("\"order\": %d, \"residue_per_kg\": [%.9g]}", m, X * X / rho / norm[m])
  }
  text = text sprintf("], \"sensors\": [{\"position_m\": %g}], \"impact\": {\"position_m\": %g},", at, at)
  text = text sprintf("\"pulse\": {\"kind\": \"halfsine\", \"width_s\": %.9g, \"peak_n\": %.9g,", width, peak)
  text = text "\"width_spread\": 0, \"peak_spread\": 0}, \"noise\": {\"force\": 0.001, \"accel\": 0.001},"
  print text "\"recorder\": {\"accel_bias_mps2\": 0.5}}" > name
}
FNR == 1 { ++file }
file == 1 && /frequency_hz/ { left = 5; next }
file == 1 && left { f[6 - left--] = $1 + 0 }
file == 2 && FNR > 1 {
  x[++rows] = $1
  for (m = 1; m <= 5; ++m) {
    shape[m, rows] = $(m + 1)
    if (rows > 1) norm[m] += ($1 - x[rows - 1]) * (shape[m, rows] ^ 2 + shape[m, rows - 1] ^ 2) / 2
  }
}
file == 3 && FNR > 1 { specification(bat "-" ++points ".json", $4, $7, 1.5707963 * 0.16 * 5 * (1 + $6) / $7, 1.2) }
END { specification(bat "-hammer.json", 0.48, 0.0004, 300, 4) }' $1.beam.json $1.beam.csv $1.sweep.csv
for point in 1 2 3 4 5 6 7 8 9; do
  percuss synth $1-$point.json --seed $point -o record.csv --force > /dev/null
  cut -d, -f1,2,4 record.csv > $1-$point.csv
done
percuss synth $1-hammer.json -o $1-hammer.h5 > /dev/null
END'''


def section():
    s = Section('A ball on a cricket bat [9]', """\
The scan of this source has lost the numbers of its tables and most numbers of its figures; the text, and a few labels
of axes, keep some. The composite bat is EI = 4000 N·m², T = 1200 N·m/rad, ρA = 2.24 kg/m, 0.57 m long. The source does
not state the Hertz constant of its ball; 3.2·10⁶ N/m^1.5 gives its restitution. The nine struck points are 25 to 545 mm
from the handle. Synthetic tests take the place of its records: `impact-test.sh` makes them from the modes of a model
beam, with damping ratios of 0.5 %, noise and an offset. They have no force channel, and start when the ball crosses a
light beam 0.5 m away. The EI and T of the traditional bat are illegible; a second bat of our own, EI = 3000 N·m²,
T = 800 N·m/rad, ρA = 2.6 kg/m, takes its place.""", 'tables 1 to 3; figures 1 to 13')
    s.frequencies = [s.command('percuss model beam%s -o %s.json --quiet > /dev/null' % (support, name)) for support, name in
                     (('', 'beam'), (' --support pinned', 'pinned'), (' --support clamped', 'clamped'))]
    s.curves = s.command('percuss model impact --sweep %s --curves -o cricket-7.svg -o cricket-7.csv --quiet > /dev/null' % PLACES)
    s.places = s.command('percuss model impact --sweep %s -o cricket-10.svg -o cricket-10.csv --quiet > /dev/null' % PLACES)
    s.few = s.command('percuss model impact --sweep %s --modes 3 -o three-modes.csv --quiet > /dev/null' % PLACES)
    s.sweeps = [s.command('percuss model impact --sweep %s -o cricket-%d.svg -o cricket-%d.csv --quiet > /dev/null' % (text, n, n))
                for n, text in ((11, 'ei=1000:1000:6000'), (12, 'torsion=500:500:3000'), (13, 'rho-a=0.6:0.2:3'))]
    s.script = s.command(IMPACT_TEST)
    s.tests = {name: impact_test(s, name, *numbers) for name, numbers in BATS.items()}
    return s


def impact_test(s, name, stiffness, torsion, mass_per_length):
    """The commands that make an impact test and a hammer test of a bat, and compare both with the model beam."""
    beam = 'ei=%g,rho_a=%g,torsion=%g,length=0.57' % (stiffness, mass_per_length, torsion)
    return [s.command('sh impact-test.sh %s %g %g %g' % (name, stiffness, torsion, mass_per_length)),
            s.command('percuss analyze %s-hammer.h5 --band 5:5000 --object other -o %s.modal.json --quiet > /dev/null'
                      % (name, name)),
            s.command('percuss deflect %s-[1-9].csv --files points --positions 0.025:0.065:0.545 --beam-distance 0.5 '
                      '--band 5:5000 --object other --beam %s --compare %s.modal.json -o %s.impact.json '
                      '-o %s.impact.svg -o %s.impact.csv --quiet > /dev/null' % (name, beam, name, name, name, name))]


def three_columns(s, name):
    """Frequencies of a bat in Hz: modal test, model beam and impact test, for the modes that all three have."""
    document = s.document(name + '.impact.json')
    test = [mode['frequency_hz'] for mode in document['modes']]
    compared = document['comparison']
    modal, model = ({pair['a']: pair['frequency_b_hz'] for pair in pairs}
                    for pairs in (compared['pairs'], compared['others'][0]['pairs']))
    return [(modal[m], model[m], f) for m, f in enumerate(test) if m in modal and m in model]


def rises(values):
    return all(b > a for a, b in zip(values, values[1:]))


def flattens(values):
    steps = [b - a for a, b in zip(values, values[1:])]
    return rises([-step for step in steps])


def fill(s):
    beam, pinned, clamped = (s.document(name + '.json')['frequency_hz'] for name in ('beam', 'pinned', 'clamped'))
    first = s.table('cricket-11.csv')[3]
    for key, name, unit, value in (('ei', 'EI', ' N·m²', 4000), ('torsion', 'T', ' N·m/rad', 1200),
                                   ('rho_a', 'ρA', ' kg/m', 2.24)):
        s.number('table 1', 'default %s of the composite bat' % name, value, first[key], s.sweeps[:1], unit, 2)
    s.row('table 3', 'composite bat, column of the model', 'illegible',
          ', '.join('%.2f' % f for f in beam[:3]) + ' Hz', '–', s.frequencies[:1])
    for place, name, what in (('table 3', 'composite', 'composite bat'), ('table 2', 'other', 'second bat')):
        for n, columns in enumerate(three_columns(s, name)[:3], 1):
            s.row(place, '%s, mode %d: modal test, model, impact test (synthetic)' % (what, n), 'illegible',
                  '%.4f, %.4f, %.4f Hz' % columns, 'model differs by %s %% from the impact test' %
                  signed(100 * (columns[1] / columns[2] - 1), 4), s.tests[name][1:])
    between = sum(low < f < high for low, f, high in zip(pinned, beam, clamped))
    s.agrees('theory', 'each frequency lies between simple/free and clamped/free', 'all modes',
             '%d of %d' % (between, len(beam)), between == len(beam), s.frequencies)
    curves = s.table('cricket-7.csv')
    places = sorted({row['at'] for row in curves})
    s.row('figure 7', 'deflection over time at all struck points (composite bat, model)', '9 curves',
          '%d curves' % len(places), 'the same points', [s.curves])
    for place, name, what in (('figure 8', 'composite', 'composite bat'), ('figure 5', 'other', 'second bat')):
        places = {row['position_m'] for row in s.table(name + '.impact.csv')}
        s.agrees(place, 'deflection over time at all struck points (%s, impact test without force, synthetic)' % what,
                 '9 curves', '%d curves' % len(places), len(places) == 9, s.tests[name])
    largest = s.table('cricket-10.csv')
    s.row('figure 10', 'largest deflection over position (model, 5 m/s)', 'axis to 25 mm; speed not stated',
          '%.3f mm at 25 mm to %.2f mm at 545 mm' % (1e3 * largest[0]['peak_deflection_m'],
                                                     1e3 * largest[-1]['peak_deflection_m']), '–', [s.places])
    change = max(abs(a['peak_deflection_m'] - b['peak_deflection_m'])
                 for a, b in zip(largest, s.table('three-modes.csv')))
    s.agrees('figures 7, 10', 'contribution of modes four and above to the largest deflection', 'negligible',
             'at most %.4f mm' % (1e3 * change), change < 1e-4, [s.places, s.few])
    for place, name, what, factor in (('figure 10', 'composite', 'composite bat', 1.6),
                                      ('figure 9', 'other', 'second bat', 1.65)):
        model = s.document(name + '.impact.json')['comparison']['others'][0]['deflections']
        ratios = [pair['ratio'] for pair in model]
        s.row(place, 'largest deflection, model over impact test (%s, synthetic), from 25 to 545 mm' % what,
              '%g%s' % (factor, '' if name == 'composite' else ' at the tip'),
              '%.4f to %.4f' % (ratios[0], ratios[-1]),
              'the test differs from the model in its damping and in its pulse, a half sine', s.tests[name])
    speeds = [one['speed_mps'] for one in s.document('composite.impact.json')['impact_speeds']]
    s.number('theory', 'speed of the ball from the light beam to the first touch (synthetic), mean', 5,
             sum(speeds) / len(speeds), s.tests['composite'], ' m/s', 4)
    for number, command, what, shape in (
            (11, 0, 'restitution over EI, 1000 to 6000 N·m²', 'rises, less and less'),
            (12, 1, 'restitution over T, 500 to 3000 N·m/rad', 'axis 0.465 to 0.475; very little effect'),
            (13, 2, 'restitution over ρA, 0.6 to 3 kg/m', 'axis to 0.6; very low for light bats, then flattens')):
        cor = [row['cor'] for row in s.table('cricket-%d.csv' % number)]
        holds = {11: rises(cor) and flattens(cor), 12: 0.465 < min(cor) and max(cor) < 0.475 and max(cor) - min(cor) < 1e-3,
                 13: rises(cor) and flattens(cor) and cor[0] < 0.1 and 0.5 < cor[-1] < 0.6}[number]
        s.agrees('figure %d' % number, what, shape, '%.4f to %.4f' % (cor[0], cor[-1]), holds, [s.sweeps[command]])
    s.not_reproduced('table 1', 'traditional bat, and dimensions', 'measured; illegible in the scan')
    s.not_reproduced('tables 2, 3', 'frequencies of the real bats', 'measured, and illegible. The commands print these columns '
               'from your records; `percuss model beam --profile` has non-uniform blades')
    s.not_reproduced('figures 1, 2', 'photograph; set-up', 'no computation')
    s.not_reproduced('figures 3, 6', 'measured shapes and frequencies', 'the records are not published. `percuss survey` makes '
               'them from a record of 23 points')
    s.not_reproduced('figure 4', 'model of the traditional bat', 'its EI and T are illegible; otherwise as figure 7')
    s.not_reproduced('figures 5, 8 to 10', 'measured deflections of the real bats', 'the records are not published. The commands '
               'make the figures from your records; [Deflection](../tutorials/deflection.md) leads through them')
