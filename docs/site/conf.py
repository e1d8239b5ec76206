"""How Sphinx makes the site of what build.py has laid out."""

import boresight

project = "Boresight"
release = boresight.__version__
copyright = "the authors of Boresight"
extensions = ["myst_parser", "sphinx_design", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "numpydoc"]
html_theme = "furo"
html_title = "Boresight"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = html_show_sphinx = False
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
suppress_warnings = ["misc.highlighting_failure"]
numpydoc_show_class_members = False
autodoc_typehints = "none"
nitpicky = False
