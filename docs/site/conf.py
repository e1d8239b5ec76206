"""How Sphinx makes the site of what build.py has laid out."""

import boresight

project = "Boresight"
release = boresight.__version__
copyright = "the authors of Boresight"
extensions = ["myst_parser", "sphinx_design", "sphinx.ext.autodoc", "numpydoc"]
html_theme = "furo"
html_title = "Boresight"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["filter.js"]
html_copy_source = html_show_sphinx = False
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
highlight_language = "none"
pygments_dark_style = "github-dark"
default_role = "py:obj"  # of a docstring: a name in backticks is a link where it is documented
smartquotes = False  # x' is a derivative
numpydoc_show_class_members = False
autodoc_typehints = "none"
add_module_names = toc_object_entries = False


def marked_up(app, what, name, value, options, lines):
    """A docstring is no reStructuredText: |x| is an absolute value there, and an item goes on without an indent."""
    item = False
    for i, line in enumerate(lines):
        if not line.lstrip().startswith((">>>", "...")):
            lines[i] = line.replace("|", r"\|")
        if item and line[:1] not in ("", " ", "-"):
            lines[i] = "  " + lines[i]
        item = line.startswith("- ") or (item and bool(line))


MENUS: dict[str, str] = {}


def menu(app, page, template, context, doctree):
    """Pages that are not in the menu have one menu for each folder: to make menus costs half of the time."""
    if "orphan" in app.env.metadata.get(page, {}):
        folder, toctree = page.rpartition("/")[0], context["toctree"]
        context["toctree"] = lambda **how: (
            MENUS[folder] if folder in MENUS else MENUS.setdefault(folder, toctree(**how))
        )


def setup(app):
    app.connect("autodoc-process-docstring", marked_up)
    app.connect("html-page-context", menu, priority=100)  # before the theme
