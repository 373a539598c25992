# The manual by Sphinx: `make docs` copies the pages beside this file and runs it.
import glob
import os
import re

project = "pepperpot"
author = "the authors of pepperpot"
copyright = author
version = release = os.environ.get("PEPPERPOT_VERSION", "")
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "index"
suppress_warnings = ["myst.header"]
myst_heading_anchors = 4
myst_enable_extensions = []
smartquotes = False
highlight_language = "none"

html_theme = "furo"
html_title = "pepperpot"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_theme_options = {"footer_icons": []}

latex_documents = [("index", "pepperpot.tex", "pepperpot", author, "manual")]
latex_engine = "xelatex"

# A man page for every command: its name, its summary and its page.
man_pages = []
for page in sorted(glob.glob(os.path.join(os.path.dirname(__file__), "commands", "*.md"))):
    name = os.path.basename(page)[:-3]
    if name == "index":
        continue
    with open(page, encoding="utf-8") as file:
        text = file.read().split("\n\n")
    summary = re.sub(r"\s+", " ", text[1]).split(". ")[0].rstrip(".")
    man_pages.append(("commands/" + name, "pepperpot-" + name, summary, [author], 1))
