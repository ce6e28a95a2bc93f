"""Configures Sphinx for the HTML pages; cmake/PercussDocs.cmake runs Sphinx from the top of the sources."""

import os
import pathlib
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOP / "docs" / "sphinx"))

project = "percuss"
author = "the percuss authors"
copyright = author
version = release = os.environ.get("PERCUSS_VERSION", "")
root_doc = "docs/index"
include_patterns = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs/**.md"]
exclude_patterns = ["build", ".*"]

extensions = ["myst_parser", "sphinx.ext.autodoc", "percuss_pages", "sphinx.ext.napoleon", "breathe"]
myst_heading_anchors = 3
suppress_warnings = ["misc.highlighting_failure"]  # console examples with a quoted argument over several lines
highlight_language = "none"  # of blocks without a language: equations and layouts
napoleon_google_docstring = False
napoleon_use_ivar = True  # "Attributes" of a class does not declare its properties again
autodoc_member_order = "bysource"
breathe_projects = {"percuss": os.environ.get("PERCUSS_DOXYGEN_XML", "")}
breathe_default_project = "percuss"
breathe_show_include = False
cpp_headers = os.environ.get("PERCUSS_HEADERS", "").split(":")  # relative to include/
python_package = os.environ.get("PERCUSS_PYTHON_PACKAGE", "")  # the folder of the built module; empty: not built

html_theme = "furo"
html_title = f"percuss {version}"
html_static_path = ["sphinx/static"]
html_css_files = ["percuss.css"]
html_extra_path = ["sphinx/extra"]
html_copy_source = False
html_show_copyright = False
pygments_style = "friendly"
