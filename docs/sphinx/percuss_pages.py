"""Adds the navigation and the C++ headers to Sphinx, and converts docstrings to reStructuredText."""

import pathlib
import re
import sys
import textwrap

from breathe.renderer.sphinxrenderer import SphinxRenderer, WithContext

_LINK = re.compile(r"^- \[[^\]]+\]\(([^)]+)\.md\)", re.MULTILINE)


def _navigation(text):
    """Adds a hidden toctree after each section of the index, with the pages that the section links to."""
    head, *sections = re.split(r"(?m)^(?=## )", text)
    parts = [head]
    for section in sections:
        caption = section.splitlines()[0].removeprefix("## ")
        pages = "\n".join(_LINK.findall(section))
        parts.append(f"{section}\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{pages}\n```\n\n")
    return "".join(parts)


_SECTIONS = (
    "briefdescription detaileddescription define typedef enum innerclass func var innernamespace public-type "
    "public-func public-static-func public-attrib public-static-attrib friend related user-defined"
)  # without private and protected members


def _cpp_reference(headers):
    if not any(headers):
        return "This build found no public headers.\n"
    return "\n".join(f"## `{name}`\n\n```{{doxygenfile}} {name}\n:sections: {_SECTIONS}\n```\n" for name in headers)


def _python_reference(built):
    if built:
        return "\n".join(
            f"## {name}\n\n```{{eval-rst}}\n.. automodule:: {name}\n   :members:\n   :imported-members:\n```\n"
            for name in ("percuss", "percuss.models", "percuss.metrics")
        )
    note = "This build has no Python module, so the reference shows the sources. Configure with `-DPERCUSS_PYTHON=ON`.\n"
    folder = pathlib.Path(__file__).resolve().parents[2] / "python" / "percuss" / "_functions"
    return note + "\n".join(
        f"\n## percuss.{one.stem.replace('_', '.')}\n\n```{{literalinclude}} ../../python/percuss/_functions/{one.name}\n:language: python\n```\n"
        for one in sorted(folder.glob("[a-z]*.py"))
    )


def _complete(app, docname, source):
    if docname == app.config.root_doc:
        source[0] = _navigation(source[0])
    elif docname == "docs/reference/cpp":
        source[0] += _cpp_reference(app.config.cpp_headers)
    elif docname == "docs/reference/python":
        source[0] += _python_reference(app.config.python_package)


def _visit_namespace(self, node):
    """Renders only the members: many headers open one namespace, and Breathe would declare it for each header."""
    file_data = self.compound_parser.parse(node.refid)
    context = self.context.create_child_context(file_data)
    with WithContext(self, context.create_child_context(file_data.compounddef)):
        return self.render(file_data, context)


SphinxRenderer.visit_namespace = _visit_namespace

_TERM = re.compile(r"    (\S+(?: \[[^\]]*\])?)  +(\S.*)")  # "    band [LO:HI]  Analyse this band"
_COLUMNS = re.compile(r"\S.*?\S {2,}\S.*")  # "frequency_hz, damping_ratio    (modes,)"


def _escaped(text):
    """Escapes plain text and keeps `code` as code."""
    parts = re.split(r"`([^`]+)`", text)
    parts[::2] = [re.sub(r"([\\*`|_])", r"\\\1", part) for part in parts[::2]]
    return "".join(f"``{part}``" if i % 2 else part for i, part in enumerate(parts))


def _definitions(lines):
    """Makes a definition list from "    name  explanation", whose continuation lines are indented further."""
    out = []
    for line in lines:
        term = _TERM.fullmatch(line)
        out += ["", f"``{term[1]}``", "   " + _escaped(term[2])] if term else ["   " + _escaped(line.strip())]
    return out


def _as_rst(block):
    """Converts a paragraph of a plain docstring. Examples stay; lists of "name  explanation" become definitions."""
    lines = block.splitlines()
    if all(_COLUMNS.fullmatch(line) for line in lines):
        lines = ["    " + line for line in lines]
    indented = [line for line in lines if line.startswith(" ")]
    if lines[0].lstrip().startswith(">>>"):
        return textwrap.dedent(block).splitlines()
    if lines[0].endswith(":") and len(indented) == len(lines) - 1 > 0 and _TERM.fullmatch(indented[0]):
        return [f"**{_escaped(lines[0])}**", *_definitions(indented)]
    if indented:
        text = [_escaped(line) for line in lines if line not in indented]
        return [*text, "", "::", "", *("   " + line for line in indented)]
    return [_escaped(line) for line in lines]


_NUMPY_HEADING = re.compile(r"(?m)^[A-Z][\w ]*\n-{3,}$")  # napoleon converts docstrings with such headings


def _docstring(app, what, name, obj, options, lines):
    if _NUMPY_HEADING.search("\n".join(lines)):
        lines[:] = [re.sub(r"(?<!`)`([^`]+)`(?!`)", r"``\1``", line) for line in lines]
        return
    blocks = re.split(r"\n{2,}", "\n".join(lines).strip("\n"))
    lines[:] = [line for block in blocks if block for line in [*_as_rst(block), ""]]


def setup(app):
    app.add_config_value("cpp_headers", [], "env")
    app.add_config_value("python_package", "", "env")
    app.connect("source-read", _complete)
    app.connect("autodoc-process-docstring", _docstring)
    app.connect("builder-inited", lambda app: sys.path.insert(0, app.config.python_package))
    return {"parallel_read_safe": True}
