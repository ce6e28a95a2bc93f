"""Source [9]: a ball on a cricket bat."""
from sources.page import Section

PLACES = 'at=0.025:0.065:0.545'


def section():
    s = Section('A ball on a cricket bat [9]', """\
The scan of this source has lost the numbers of its tables and most numbers of its figures; the text, and a few labels
of axes, keep some. The composite bat is EI = 4000 N·m², T = 1200 N·m/rad, ρA = 2.24 kg/m, 0.57 m long. The source does
not state the Hertz constant of its ball; 3.2·10⁶ N/m^1.5 gives its restitution. The nine struck points are 25 to 545 mm
from the handle.""", 'tables 1 to 3; figures 1 to 13')
    s.frequencies = [s.command('percuss model beam%s -o %s.json --quiet' % (support, name)) for support, name in
                     (('', 'beam'), (' --support pinned', 'pinned'), (' --support clamped', 'clamped'))]
    s.curves = s.command('percuss model impact --sweep %s --curves -o cricket-7.svg -o cricket-7.csv --quiet' % PLACES)
    s.places = s.command('percuss model impact --sweep %s -o cricket-10.svg -o cricket-10.csv --quiet' % PLACES)
    s.few = s.command('percuss model impact --sweep %s --modes 3 -o three-modes.csv --quiet' % PLACES)
    s.sweeps = [s.command('percuss model impact --sweep %s -o cricket-%d.svg -o cricket-%d.csv --quiet' % (text, n, n))
                for n, text in ((11, 'ei=1000:1000:6000'), (12, 'torsion=500:500:3000'), (13, 'rho-a=0.6:0.2:3'))]
    return s


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
    between = sum(low < f < high for low, f, high in zip(pinned, beam, clamped))
    s.agrees('theory', 'each frequency lies between simple/free and clamped/free', 'all modes',
             '%d of %d' % (between, len(beam)), between == len(beam), s.frequencies)
    curves = s.table('cricket-7.csv')
    places = sorted({row['at'] for row in curves})
    s.row('figure 7', 'deflection over time at all struck points (composite bat, model)', '9 curves',
          '%d curves' % len(places), 'the same points', [s.curves])
    largest = s.table('cricket-10.csv')
    s.row('figure 10', 'largest deflection over position (model, 5 m/s)', 'axis to 25 mm; speed not stated',
          '%.3f mm at 25 mm to %.2f mm at 545 mm' % (1e3 * largest[0]['peak_deflection_m'],
                                                     1e3 * largest[-1]['peak_deflection_m']), '–', [s.places])
    change = max(abs(a['peak_deflection_m'] - b['peak_deflection_m'])
                 for a, b in zip(largest, s.table('three-modes.csv')))
    s.agrees('figures 7, 10', 'contribution of modes four and above to the largest deflection', 'negligible',
             'at most %.4f mm' % (1e3 * change), change < 1e-4, [s.places, s.few])
    for number, command, what, shape in (
            (11, 0, 'restitution over EI, 1000 to 6000 N·m²', 'rises, less and less'),
            (12, 1, 'restitution over T, 500 to 3000 N·m/rad', 'axis 0.465 to 0.475; very little effect'),
            (13, 2, 'restitution over ρA, 0.6 to 3 kg/m', 'axis to 0.6; very low for light bats, then flattens')):
        cor = [row['cor'] for row in s.table('cricket-%d.csv' % number)]
        holds = {11: rises(cor) and flattens(cor), 12: 0.465 < min(cor) and max(cor) < 0.475 and max(cor) - min(cor) < 1e-3,
                 13: rises(cor) and flattens(cor) and cor[0] < 0.1 and 0.5 < cor[-1] < 0.6}[number]
        s.agrees('figure %d' % number, what, shape, '%.4f to %.4f' % (cor[0], cor[-1]), holds, [s.sweeps[command]])
    s.not_made('table 1', 'traditional bat, and dimensions', 'measured; illegible in the scan')
    s.not_made('tables 2, 3', 'frequencies of modal test, model and impact test',
               'measured, and illegible. `percuss deflect RECORD --beam ei=4000,speed=5 --compare TEST.json` prints these '
               'columns from your records; `percuss model beam --profile` has non-uniform blades')
    s.not_made('figures 1, 2', 'photograph; set-up', 'no computation')
    s.not_made('figures 3, 6', 'measured shapes and frequencies', 'the records are not published. `percuss survey` makes '
               'them from a record of 23 points')
    s.not_made('figure 4', 'model of the traditional bat', 'its EI and T are illegible; otherwise as figure 7')
    s.not_made('figures 5, 8', 'measured deflection over time', 'the records are not published. `percuss deflect RECORD '
               '--positions 0.025:0.065:0.545 -o X.svg` draws all struck points, and the largest deflection over position')
    s.not_made('figures 9, 10', 'measured deflections; model over test 1.6 and 1.65',
               'the measured values are not published. `percuss deflect` with `--beam` prints the ratio at each point '
               'and draws both curves; [Deflection](../tutorials/deflection.md) shows it')
