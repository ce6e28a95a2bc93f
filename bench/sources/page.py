"""Builds docs/project/sources-reproduced.md: sections, commands, rows, and the wording of the differences."""
import csv
import json
import os
import re
import subprocess
import textwrap

REPRODUCED = '| from | what | source | percuss | difference | commands |\n|---|---|---:|---:|---|---|\n'
NOT_REPRODUCED = '| from | shows | why not, and what percuss makes instead |\n|---|---|---|\n'


class Section:
    """A source: its commands, which run in order, and the rows of its table, read from files that the commands write."""

    def __init__(self, title, about, expected):
        self.title, self.about, self.expected = title, about, expected
        self.commands, self.rows, self.reasons, self.named = [], [], [], set()

    def command(self, text):
        """Adds a shell command; returns its number."""
        self.commands.append(text)
        return len(self.commands)

    def row(self, place, what, source, value, difference, commands):
        self.named |= set(places_in(place))
        numbers = ', '.join(str(n) for n in commands)
        self.rows.append('| %s | %s | %s | %s | %s | %s |' % (place, what, source, value, difference, numbers))

    def number(self, place, what, source, value, commands, unit='', digits=4):
        """Adds a row: a number of the source and a number of percuss."""
        change = value - source
        if change == 0:
            return self.row(place, what, '%g%s' % (source, unit), '%g%s' % (value, unit), 'none', commands)
        text = signed(change, digits) + unit
        if source:
            text += ' (%s %%)' % signed(100 * change / source, 2)
        return self.row(place, what, '%g%s' % (source, unit), '%.*f%s' % (digits, value, unit), text, commands)

    def within(self, place, what, low, high, value, commands, unit='', digits=4):
        """Adds a row: a range of the source and a number of percuss."""
        beyond = value - high if value > high else min(0, value - low)
        text = '%s%s outside' % (signed(beyond, digits), unit) if beyond else 'inside'
        self.row(place, what, '%g to %g%s' % (low, high, unit), '%.*f%s' % (digits, value, unit), text, commands)

    def agrees(self, place, what, source, value, agrees, commands):
        """Adds a row: a statement of the source, and the finding of percuss."""
        self.row(place, what, source, value, 'agrees' if agrees else 'differs', commands)

    def not_reproduced(self, place, shows, reason):
        self.named |= set(places_in(place))
        self.reasons.append('| %s | %s | %s |' % (place, shows, reason))

    def run(self, folder, tool):
        """Runs the commands in a folder. They may read files of earlier sections, which run first."""
        self.folder = folder
        path = os.path.dirname(os.path.abspath(tool)) + os.pathsep + os.environ['PATH']
        for text in self.commands:
            done = subprocess.run(['sh', '-c', text], cwd=folder, capture_output=True, text=True, check=False,
                                  env={**os.environ, 'PATH': path})
            if done.returncode or done.stdout or done.stderr:
                raise SystemExit('%s\n%s%sexit code %d' % (text, done.stdout, done.stderr, done.returncode))

    def document(self, name):
        with open(os.path.join(self.folder, name), encoding='utf-8') as file:
            return json.load(file)

    def table(self, name):
        """The rows of a CSV file, by column name. Cells that hold a number are floats, the others text."""
        with open(os.path.join(self.folder, name), encoding='utf-8') as file:
            return [{k: number_or_text(v) for k, v in row.items()} for row in csv.DictReader(file)]

    def text(self):
        missing = sorted(set(places_in(self.expected)) - self.named)
        if missing:
            raise SystemExit('%s: nothing is said about %s' % (self.title, ', '.join(missing)))
        out = '## %s\n\n%s\n\n' % (self.title, wrapped(self.about))
        out += REPRODUCED + '\n'.join(self.rows) + '\n\n```console\n'
        for n, text in enumerate(self.commands, 1):
            first, *rest = text.split('\n')
            out += '$ %s  # %d\n' % (first, n) + ''.join('> %s\n' % line for line in rest)
        out += '```\n'
        if self.reasons:
            out += '\nNot reproduced, with the reason:\n\n' + NOT_REPRODUCED + '\n'.join(self.reasons) + '\n'
        return out


def signed(value, digits):
    """Formats a value with its sign, or without a sign if it rounds to zero."""
    text = '%+.*f' % (digits, value)
    return text[1:] if float(text) == 0 else text


def number_or_text(cell):
    try:
        return float(cell)
    except ValueError:
        return cell


def places_in(text):
    """'figures 13 to 15, B1; table 2' as ['figure 13', 'figure 14', 'figure 15', 'figure B1', 'table 2']."""
    out, kind = [], ''
    for part in re.split(r'[,;]', text):
        found = re.match(r'\s*(figure|table)?s?\s*([A-Z]?)(\d+)(?: to [A-Z]?(\d+))?', part)
        if not found:
            continue
        kind = found[1] or kind
        last = int(found[4] or found[3])
        out += ['%s %s%d' % (kind, found[2], n) for n in range(int(found[3]), last + 1)]
    return out


def wrapped(text):
    return '\n\n'.join(textwrap.fill(' '.join(part.split()), 120, break_on_hyphens=False, break_long_words=False)
                       for part in text.split('\n\n'))


NUMBER = re.compile(r'(?<![\w.])[+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w.])')


def same_line(one, other):
    """Whether two lines agree. Numbers with decimals may differ by one in their last digit."""
    if NUMBER.split(one) != NUMBER.split(other):
        return False
    for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)):
        decimals = [len(x.partition('.')[2]) for x in (a, b)]
        if a != b and ('e' in a + b or decimals[0] != decimals[1] or not decimals[0] or
                       abs(float(a) - float(b)) > 1.01 * 10 ** -decimals[0]):
            return False
    return True
