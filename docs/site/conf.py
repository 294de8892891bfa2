"""Settings of Sphinx for the site: the Markdown pages of the project as they are, with README.md as the first one."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

project = "pongsim"
author = "the pongsim authors"
extensions = ["myst_parser"]
myst_heading_anchors = 4
root_doc = "README"
html_theme = "furo"
html_title = "pongsim"
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
templates_path = ["templates"]
html_sidebars = {
    "**": ["sidebar/brand.html", "sidebar/search.html", "sidebar/scroll-start.html", "sidebar/navigation.html",
           "sidebar/api.html", "sidebar/scroll-end.html"]
}

# the pages in the sidebar, in the order of the README's table
CHAPTERS = {
    "Getting started": ["installation", "tutorials", "cli", "gazebo", "ci"],
    "Worlds and robots": ["sdf", "urdf", "fuel", "systems", "sensors"],
    "Connecting": ["ros2", "ign", "web", "lockstep", "logs", "replay", "security"],
    "Python": ["python", "gym", "sweeps", "testing"],
    "Extending": ["plugins", "extensions"],
    "Measured": ["physics", "determinism", "performance", "transport"],
    "Development": ["development", "design", "dependencies"],
}
LISTED = {page for pages in CHAPTERS.values() for page in pages}
UNLISTED = sorted(path.stem for path in (ROOT / "docs").glob("*.md") if path.stem not in LISTED)
# READMEs of folders that pages link to
FOLDERS = ["components", "include/pongsim", "plugins", *(f"components/{component}" for component in (
    "fuel", "ign", "log", "python", "ros2", "ros2/test/rclpy_stand_in", "shared", "shared/program", "video", "web"))]

include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "docs/*.md", "plugins/*/*/README.md",
                    *(f"{folder}/README.md" for folder in FOLDERS)]


def toctree(pages, caption=None):
    lines = ["```{toctree}", ":hidden:", *([f":caption: {caption}"] if caption else []), *pages, "```"]
    return "\n\n" + "\n".join(lines) + "\n"


def link_to_what_is_there(folder, match):
    """A link to a folder leads to its README, or is plain text where the site has none."""
    text, target = match.groups()
    path = (folder / target).resolve()
    if not path.is_dir():
        return match.group(0)
    readme = path / "README.md"
    return f"[{text}]({target.rstrip('/')}/README.md)" if str(readme.relative_to(ROOT)) in include_patterns else text


def prepare(app, page, source):
    """Leaves out comments for tests, mends links to folders, and adds the lists of pages for the sidebar."""
    text = re.sub(r"^<!-- .* -->\n", "", source[0], flags=re.MULTILINE)
    folder = (ROOT / page).parent
    text = re.sub(r"\[([^\]]*)\]\(([^)#:]+)\)", lambda match: link_to_what_is_there(folder, match), text)
    if page == root_doc:
        for caption, pages in CHAPTERS.items():
            text += toctree([f"docs/{name}" for name in pages], caption)
        text += toctree([*(f"docs/{name}" for name in UNLISTED), "CHANGELOG", "CONTRIBUTING", "SECURITY"], "More")
    if page == "docs/systems":
        systems = sorted((ROOT / "plugins").glob("*/*/README.md"), key=lambda path: path.parent.name)
        text += toctree([f"/{path.relative_to(ROOT).with_suffix('')}" for path in systems])
    if page == "docs/design":
        text += toctree([f"/{folder}/README" for folder in FOLDERS])
    source[0] = text


def language_of(code):
    first = code.lstrip()
    if first.startswith("<"):
        return "xml"
    if first.startswith("{"):
        return "json"
    if re.match(r"(from \w+(\.\w+)* )?import |\"\"\"", first):
        return "python"
    if re.match(r"- |[a-z_]+:( |\n)", first) or first.startswith("# ") and "\n- " in first:
        return "yaml"
    if "std::" in code or "->" in code or "<ignition::" in code:
        return "cpp"
    return "bash"


def name_languages(app, doctree):
    """Indented code says no language: it is told by how it begins."""
    from docutils import nodes

    for block in doctree.findall(nodes.literal_block):
        if "language" not in block:
            block["language"] = language_of(block.astext())
            block["force"] = True


def setup(app):
    app.connect("source-read", prepare)
    app.connect("doctree-read", name_languages)
