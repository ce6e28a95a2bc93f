#!/usr/bin/env python3
"""sources_reproduced.py [--percuss TOOL] [--check] PAGE

Writes PAGE, docs/project/sources-reproduced.md: for every table and figure of the three sources that software can make,
the source's number, percuss's number, their difference and the command. For each table and figure that percuss does not
make, it gives the reason. Runs the commands in a temporary folder. With --check, writes nothing and exits with 1 if
PAGE does not agree with the tool.

  --percuss   the tool (default: build/release/tools/percuss)
"""
import argparse
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True
from sources import baseball, cricket, sweet_spot  # noqa: E402
from sources.page import places_in, same_line, wrapped  # noqa: E402

ABOUT = """\
percuss implements the computations of three works: a thesis on baseball bats [8], a work on the design of cricket bats
[9] and a paper on the sweet spot [10] ([sources](../theory/sources.md)). This page compares percuss with them. It lists every table and figure that
software can make, with the source's number and the command. For each table and figure that percuss does not make, it
states the reason. "Commands" are the numbers of the commands below its table; all commands of the page run in order, in
one empty folder.

None of the three works publishes records, or the points of figures. Where the source shows measurements, the command shows
the same figure of a synthetic test or population, which is no evidence about bats; the row says so. "text" and
"theory" rows are numbers outside figures.

`bench/sources_reproduced.py docs/project/sources-reproduced.md` writes this page; with `--check`, it compares it with
the tool."""


def page_of(tool):
    made = named = 0
    texts = []
    with tempfile.TemporaryDirectory() as folder:
        for module in (baseball, cricket, sweet_spot):
            section = module.section()
            section.run(folder, tool)
            module.fill(section)
            texts.append(section.text())
            places = set(places_in(section.expected))
            by_percuss = {p for row in section.rows for p in places_in(row.split('|')[1])}
            made += len(places & by_percuss)
            named += len(places)
    head = '# The sources, reproduced\n\n%s\n\n' % wrapped(ABOUT)
    head += wrapped('Of %d tables and figures, percuss makes %d, in whole or in part.' % (named, made))
    return head + '\n\n' + '\n'.join(texts)


def differing(old, new):
    """The first line that differs; None if the pages agree."""
    a, b = old.splitlines(), new.splitlines()
    for one, other in zip(a, b):
        if not same_line(one, other):
            return '- %s\n+ %s' % (one, other)
    return None if len(a) == len(b) else '%d and %d lines' % (len(a), len(b))


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('--percuss', default='build/release/tools/percuss')
    parser.add_argument('--check', action='store_true')
    parser.add_argument('page')
    options = parser.parse_args()
    text = page_of(options.percuss)
    if options.check:
        with open(options.page, encoding='utf-8') as file:
            problem = differing(file.read(), text)
        if problem:
            raise SystemExit('%s does not agree with percuss:\n%s' % (options.page, problem))
        return
    with open(options.page, 'w', encoding='utf-8') as file:
        file.write(text)


if __name__ == '__main__':
    main()
