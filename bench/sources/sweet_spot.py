"""Source [10]: the sweet spot of a baseball bat."""
from sources.page import Section

# A wood bat of 34 in. The profile is made up, because the sources print none.
PROFILE = """position,diameter
0,1.9
0.7,1.9
1.2,1.0
12,1.0
16,1.2
20,1.65
24,2.15
27,2.4
30,2.5
33,2.45
34,2.0
"""


def section():
    s = Section('The sweet spot [10]', """\
The source is a fragment: it prints numbers for the rigid bat, and none for the flexible bat. The statements on the
flexible bat are compared with a wood bat of 34 in, the `wood.csv` of the section "Baseball bats [8]". Its profile is
made up, because the sources print none. Positions of the rigid bat are from its centre of mass.""", 'figures 1, 2; table 1')
    s.rigid = s.command('percuss model rigid -o sweet-spot.svg -o sweet-spot.csv -o rigid.json --quiet > /dev/null')
    bat = 'percuss model bat --profile wood.csv --profile-unit in:in --profile-kind points'
    s.bat = s.command(bat + ' -o wood.json --quiet > /dev/null')
    s.still = s.command(bat + ' --swing-rate 0 --wave 28in --wave-times 0:0.0002:0.001 -o wave.csv -o wave.svg --quiet > /dev/null')
    return s


def fill(s):
    rigid, curve, bat = s.document('rigid.json'), s.table('sweet-spot.csv'), s.document('wood.json')
    best = rigid['best']
    s.number('figure 2', 'largest exit speed', 27, best['exit_speed_mps'], [s.rigid], ' m/s', 2)
    s.number('figure 2', 'sweet spot, from the centre of mass', 0.13, best['z_m'], [s.rigid], ' m', 4)

    def exit_at(z):
        low = max(row['z_m'] for row in curve if row['z_m'] <= z)
        a, b = [row for row in curve if row['z_m'] >= low][:2]
        fraction = (z - a['z_m']) / (b['z_m'] - a['z_m'])
        return a['exit_speed_mps'] + fraction * (b['exit_speed_mps'] - a['exit_speed_mps'])

    loss = max(best['exit_speed_mps'] - exit_at(best['z_m'] + d) for d in (-0.05, 0.05))
    s.row('figure 2', 'loss 5 cm from the sweet spot', '11 m/s', '%.2f m/s' % loss,
          'the text must mean about 1 m/s: momentum gives 0.73', [s.rigid])
    swing = [row['swing_speed_mps'] for row in curve]
    mass = [row['effective_mass_kg'] for row in curve]
    s.agrees('figure 2', 'swing speed over position', 'rises', '%.1f to %.1f m/s' % (swing[0], swing[-1]),
             swing == sorted(swing), [s.rigid])
    s.row('figure 2', 'effective mass over position', 'the curve falls, the text says “goes up”',
          '%.3f to %.3f kg' % (mass[0], mass[-1]),
          'agrees with the curve' if mass == sorted(mass, reverse=True) else 'differs', [s.rigid])
    s.number('table 1', 'effective mass at the centre of mass', 0.83, mass[0], [s.rigid], ' kg', 2)
    at = min(bat['curve'], key=lambda row: abs(row['z_m'] - bat['best']['z_m']))
    s.row('text', 'duration of the contact at the sweet spot', 'about 1 ms', '%.2f ms' % (1e3 * at['contact_s']), '–',
          [s.bat])
    tip = bat['curve'][-1]
    s.agrees('text', 'free end: its pulse lowers the exit speed', 'below the rigid bat',
             '%.1f m/s at the tip, rigid %.1f m/s' % (tip['exit_speed_mps'], tip['rigid_exit_speed_mps']),
             tip['exit_speed_mps'] < tip['rigid_exit_speed_mps'], [s.bat])
    half = max(abs(row['exit_speed_mps'] - row['half_modes_exit_speed_mps']) for row in bat['curve'])
    s.agrees('text', 'high modes matter', 'yes', 'modes 21 to 40: up to %.2f m/s' % half, half > 0.1, [s.bat])
    wave = s.table('wave.csv')
    struck = min(wave, key=lambda row: abs(row['z_m'] - 0.7112))
    largest = max(abs(row['deflection_m_0.0002_s']) for row in wave)
    handle = max(abs(row['deflection_m_0.0002_s']) for row in wave if row['z_m'] < 0.35)
    s.agrees('text', 'the impact is local: 0.2 ms after first touch the handle rests', 'yes',
             '%.1g mm there, %.3f mm at the ball' % (1e3 * handle, 1e3 * abs(struck['deflection_m_0.0002_s'])),
             handle < 0.02 * largest, [s.still])
    s.not_reproduced('figure 1', 'the symbols', 'a drawing')
