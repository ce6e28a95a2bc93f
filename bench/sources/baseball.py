"""Source [8]: performance and modes of baseball bats."""
from sources.page import Section
from sources.sweet_spot import PROFILE

SPEEDS_MPH = (60, 80, 90, 100, 115)
# Rings of points around a barrel: their number, and the points of each.
SURVEYS = {'cylinder': (4, 8), 'barrel': (12, 10)}
GRID = """awk 'BEGIN {
  print "{\\"fs_hz\\": 25600, \\"duration_s\\": 0.5, \\"hits\\": 1, \\"structure\\": {\\"length_m\\": 0.84, \\"barrel_m\\": 0.3302,"
  print "\\"mass_kg\\": 0.87, \\"inertia_kgm2\\": 0.045, \\"cm_m\\": 0.28}, \\"modes\\": ["
  print "{\\"frequency_hz\\": 205, \\"damping_ratio\\": 0.008, \\"family\\": \\"bending\\", \\"order\\": 1, \\"angle_deg\\": 20, \\"amplitude_per_sqrt_kg\\": 1.7},"
  print "{\\"frequency_hz\\": 2100, \\"damping_ratio\\": 0.0025, \\"family\\": \\"hoop\\", \\"order\\": 1, \\"angle_deg\\": 12, \\"amplitude_per_sqrt_kg\\": 2.7}],"
  print "\\"sensors\\": [{\\"position_m\\": 0.0508, \\"angle_deg\\": 0}], \\"noise\\": {\\"force\\": 1e-4, \\"accel\\": 1e-3}, \\"impact\\": ["
  for (r = 0; r < %d; ++r) for (a = 0; a < %d; ++a)
    printf "%%s{\\"position_m\\": %%g, \\"angle_deg\\": %%g}", r + a ? "," : "", 0.0254 * (r + 1), a * 360 / %d
  print "]}"
}' > %s.spec.json"""
ABI = """cat > %s.log.json <<'END'
{"bat": {"id": "%s", "material": "composite"}, "metric": "%s", "limit": 0.76, "entries": [
 {"do": "compression", "force_lbf": [600, 600, 600, 600]}, {"do": "performance", "value": 0.72},
 {"do": "compression", "force_lbf": [500, 500, 500, 500]}, {"do": "performance", "value": %s}]}
END"""
BBCOR_BATS = ("awk -F, -v OFS=, '{ print } $5 >= 32 && $6 == \"aluminum\" && !seen[$5]++ {\n"
              "  $1 = \"C\" $1; $2 = \"\"; $8 = \"bbcor\"; $9 += 500; $16 -= 2; print\n}' bats.csv > with-bbcor.csv")


def section():
    s = Section('Baseball bats [8]', """\
Its bats, records and CCOR are not published; its figures show points without numbers. A population of 189 synthetic
bats (`percuss study --example`) and the preset `aluminium-bat`, whose first mode is the source's 205 Hz, take their
place.""", 'tables 1, 2; figures 1 to 70, A1 to A7, B1 to B5, C1 to C3, E1')
    s.swing = [s.command('percuss metrics --length-in 34 --moi-oz-in2 10450 --z-in 6 %s-o swing-%s.json --quiet > /dev/null' % x)
               for x in (('--v0-mph 40 ', '40'), ('', '60'))]
    s.tip = s.command('percuss metrics --length-in 33 --z-in 0 -o tip.json --quiet > /dev/null')
    s.profile = s.command("cat > wood.csv <<'END'\n" + PROFILE + 'END')
    s.bat = s.command('percuss model bat --profile wood.csv --profile-unit in:in --profile-kind points -o bat.json -o '
                      'figure-1.html --quiet > /dev/null')
    s.shell = s.command('percuss model shell --outer-diameter 2.625in --length 13in --wall 0.115in -o shell.json '
                        '--quiet > /dev/null')
    s.softball = s.command('percuss model trampoline --ball softball --m2 0.16 --speed 110mph -o softball.json '
                           '-o figure-4.svg --quiet > /dev/null')
    s.synth = s.command('percuss synth aluminium-bat -o bat.h5 > /dev/null')
    s.modes = s.command('percuss analyze bat.h5 --band 60:3200 --picture magnitude,coherence -o figure-12.svg '
                        '-o modes.json --quiet > /dev/null')
    s.example = s.command('percuss study --example > bats.csv')
    s.bbcor = s.command(BBCOR_BATS)
    s.study = s.command('percuss study with-bbcor.csv --figures figures -o study.json --quiet > /dev/null')
    s.walls = [s.command('percuss model trampoline --speed %dmph --hoop 1000:500:2000 -o %d.json --quiet > /dev/null' % (v, v))
               for v in SPEEDS_MPH]
    s.curve = s.command('percuss model trampoline --bats bats.csv -o figure-54.svg -o figure-54.csv -o curve.json '
                        '--quiet > /dev/null')
    s.table2 = s.command('percuss model trampoline --c2 100 -o table-2.json --quiet > /dev/null')
    trampoline = 'percuss model trampoline --extra-mass 0.145 '
    s.welded = [s.command(trampoline + '--free-hoop 2300 --loaded-hoop 1600 -o welded.json --quiet > /dev/null'),
                s.command(trampoline + '--hoop 2300:100:2400 -o loaded.json --quiet > /dev/null')]
    s.abi = []
    for name, metric, value in (('a', 'besr', 0.7059), ('b', 'besr', 0.7061), ('c', 'bbcor', 0.7019),
                                ('d', 'bbcor', 0.7021)):
        s.abi.append(s.command(ABI % (name, name, metric, value)))
        s.abi.append(s.command('percuss abi %s.log.json -o %s.abi.json --quiet > /dev/null' % (name, name)))
    s.surveys = []
    for name, (rings, around) in SURVEYS.items():
        s.surveys += [s.command(GRID % (rings, around, around, name)),
                      s.command('percuss synth %s.spec.json -o %s.h5 > /dev/null' % (name, name)),
                      s.command('percuss survey %s.h5 --band 60:3200 -o %s.html -o %s.json --quiet > /dev/null'
                                % (name, name, name))]
    return s


def fill(s):
    metrics_rows(s)
    model_rows(s)
    population_rows(s)
    modal_rows(s)
    reasons(s)


def metrics_rows(s):
    for command, name, v0 in zip(s.swing, ('40', '60'), ('40 mph, as printed', '60 mph, the default')):
        s.number('table 1', 'swing speed 6 in from the tip of a 34 in bat, with v0 = ' + v0, 66,
                 s.document('swing-%s.json' % name)['v_swing_mph'], [command], ' mph', 1)
    s.number('equation 5', 'contact speed 6 in from the tip', 136, s.document('swing-60.json')['v_contact_mph'],
             s.swing[1:], ' mph', 1)
    s.number('text', 'speed of the tip (33 in)', 85, s.document('tip.json')['v_contact_mph'] - 70, [s.tip], ' mph', 2)
    for n, metric, drop in ((0, 'BESR', 0.014), (2, 'BBCOR', 0.018)):
        verdicts = [s.document('%s.abi.json' % 'abcd'[n + i])['verdict'] for i in (0, 1)]
        s.agrees('appendix E', 'break-in: a drop of %s that passes' % metric, '%g or more' % drop,
                 '%.4f passes, %.4f does not' % (drop + 1e-4, drop - 1e-4),
                 verdicts[0] == 'pass' and verdicts[1] != 'pass', s.abi[2 * n:2 * n + 4])


def model_rows(s):
    curve, table2, softball = (s.document(name + '.json') for name in ('curve', 'table-2', 'softball'))
    for key, value in (('m1_kg', 0.145), ('k1', 60e6), ('c1', 5000), ('m2_kg', 0.09), ('a', 0.6495), ('b', 0.5202)):
        name, _, unit = key.partition('_')
        s.number('table 2', 'default ' + name, value, curve['constants'][key], [s.curve], ' kg' if unit else '', 4)
    s.row('table 2', 'c2', '100 in the table, 90.5 in the script', '%g' % curve['constants']['c2'],
          'the script, which made the figures, has 90.5; `--c2 100` gives the value of the table', [s.curve, s.table2])
    s.within('figure 54', 'hoop frequency of the largest COR', 1100, 1300, curve['peak']['hoop_hz'], [s.curve], ' Hz',
             1)
    s.within('figure 54', 'the same with c2 = 100', 1100, 1300, table2['peak']['hoop_hz'], [s.table2], ' Hz', 1)
    s.number('appendix D', 'COR by which the source normalises', 0.4892, curve['cor_10khz'], [s.curve], '', 5)
    s.row('appendix D', 'COR of a rigid wall', 'not printed', '%.5f' % curve['wall_cor'],
          'the source divides by its value at 10 kHz instead', [s.curve])
    walls = [s.document('%d.json' % v)['wall_cor'] for v in SPEEDS_MPH]
    s.agrees('figure 53', 'CCOR at 60, 80, 90, 100, 115 mph (a = 0.6495, b = 0.5202)', 'falls; values only drawn',
             ', '.join('%.4f' % w for w in walls), walls == sorted(walls, reverse=True), s.walls)
    s.within('figure 4', 'softball at 110 mph (speed not stated): hoop frequency of the largest COR', 800, 1000,
             softball['peak']['hoop_hz'], [s.softball], ' Hz', 1)
    s.number('section 4.7', 'hoop frequency with the ball on the barrel: modal mass that gives 2300 → 1600 Hz', 0.09,
             s.document('welded.json')['modal_mass_kg'], s.welded[:1], ' kg', 4)
    s.number('section 4.7', 'loaded hoop frequency with m2 of table 2', 1600,
             s.document('loaded.json')['curve'][0]['loaded_hoop_hz'], s.welded[1:], ' Hz', 1)
    at = {hz: min(curve['curve'], key=lambda row: abs(row['hoop_hz'] - hz))['cor'] for hz in (1354, 1970)}
    s.agrees('figures 67 to 69', 'break-in from 1970 to 1354 Hz: performance (model)', 'rises',
             'COR %.4f to %.4f' % (at[1970], at[1354]), at[1354] > at[1970], [s.curve])
    shell = s.document('shell.json')['flugge_hz']
    s.within('figure 2', 'first hoop mode of an aluminium barrel (2.625 in, wall 0.115 in)', 1800, 2400, shell[0],
             [s.shell], ' Hz', 1)


def population_rows(s):
    drawn = {row['source']: row['figure'] for row in s.table('figures/figures.csv')}
    named = {('%d' % k if isinstance(k, float) else k) for k in drawn}
    for places, numbers, what in (
            ('figures 13 to 18', range(13, 19), 'wood bats: performance over MOI and drop'),
            ('figures 19 to 21', range(19, 22), 'wood bats: performance over the first bending frequency'),
            ('figures 22 to 36', range(22, 37), 'nonwood bats: performance over MOI'),
            ('figures 37 to 51', range(37, 52), 'nonwood bats: performance over the first bending frequency'),
            ('figures 55 to 66', range(55, 67), 'nonwood bats: performance over the hoop frequency'),
            ('figures 67 to 69', range(67, 70), 'history of a bat in the break-in'),
            ('figures B1 to B5', ['B%d' % n for n in range(1, 6)], 'wood bats: BESR over drop, by length')):
        made = sum(str(n) in named for n in numbers)
        s.agrees(places, what + ' (synthetic)', '%d figures' % len(numbers), '%d figures' % made, made == len(numbers),
                 [s.example, s.bbcor, s.study])
    marked = sum(any(str(row['id']).startswith('CS') for row in s.table('figures/bbs-moi-nonwood-%d.csv' % n))
                 for n in (32, 33, 34))
    s.agrees('figures C1 to C3', 'nonwood bats: BBS over MOI, the bats of the BBCOR program marked (synthetic)',
             '3 figures', '%d figures' % marked, marked == 3, [s.bbcor, s.study])
    verdicts = [one['verdict'] for one in s.document('study.json')['statements']]
    s.row('sections 4, 5', 'statements about the bats (synthetic population)', '%d statements' % len(verdicts),
          ', '.join('%d %s' % (verdicts.count(v), v) for v in ('supported', 'not supported', 'contradicted')),
          'needs real bats', [s.study])


def modal_rows(s):
    bat = s.document('bat.json')
    for mode, inches in ((0, 6), (1, 5)):
        s.number('figure 1', 'node of bending mode %d from the tip, wood bat of our own' % (mode + 1), inches,
                 (bat['length_m'] - bat['node_m'][mode][-1]) / 0.0254, [s.profile, s.bat], ' in', 2)
    modes = s.document('modes.json')['modes']
    s.number('figure 12', 'first peak (synthetic)', 205, modes[0]['frequency_hz'], [s.synth, s.modes], ' Hz', 4)
    names = ['%s %d' % (m['family'], m['order']) for m in modes]
    wanted = ['bending 1', 'bending 2', 'bending 3', 'hoop 1', 'hoop 2']
    s.agrees('figures 11, 12, A7', 'the peaks, from coherence and overlaid FRFs (synthetic)', ', '.join(wanted),
             ', '.join(names), names == wanted, [s.synth, s.modes])
    for place, name, what in (('figures A2, A3', 'cylinder', 'hoop mode of a grid of 4 × 8 points, animated (synthetic)'),
                              ('figure A5', 'barrel', 'hoop mode of a grid of 12 × 10 points, animated (synthetic)')):
        hoops = [m for m in s.document(name + '.json')['modes'] if m['family'] == 'hoop']
        s.agrees(place, what, 'ellipse', '%.2f Hz, %d waves around' % (hoops[0]['frequency_hz'],
                                                                      hoops[0]['shape']['circumferential_order']),
                 len(hoops) == 1 and hoops[0]['shape']['circumferential_order'] == 2, s.surveys[:3] if name == 'cylinder' else
                 s.surveys[3:])


def reasons(s):
    s.not_reproduced('figures 3, 52', 'masses and springs', 'drawings of the model')
    s.not_reproduced('figure 5', 'softball bats of another laboratory', 'measured, not published. `percuss model trampoline '
               '--ball softball --bats BATS.csv -o X.svg` draws measured bats on the curve')
    s.not_reproduced('figures 6 to 10', 'pendulum, cannon, gates, suspension, sensors', 'photographs')
    s.not_reproduced('figure 53', 'measured CCOR, and the fit of a and b', 'measured, not published. `percuss model trampoline '
               '--fit-ccor CCOR.csv -o X.svg` fits a and b and draws both')
    s.not_reproduced('text', 'mean BBCOR of the wood bats, 0.480; ranges of MOI and frequencies', 'measured, not published. '
               '`percuss study` lists mean, range and standard deviation of each group')
    s.not_reproduced('figure 70', 'high-speed video, and finite elements with contact', 'percuss has no solid finite elements; '
               'the source calls its result inconclusive')
    s.not_reproduced('figures A1, A4, A6, E1', 'cylinder, barrel, sensors, rollers', 'photographs')
