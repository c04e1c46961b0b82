#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write the pages of the site and MkDocs' configuration: the Markdown files of the project with links that hold there.

What a page links to comes along: pictures as they are, scripts and other sources as pages that show them, headers as
the reference of the classes. The name of a script in a text (`lights.py`) becomes a link to it.
"""

import argparse
import json
import os
import re
import shutil

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
HERE = os.path.dirname(os.path.abspath(__file__))

# Pages that have another place on the site than in the project.
PLACES = {
    "README.md": "index.md",
    "Documentation/README.md": "contents.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "SECURITY.md": "security.md",
    "Data/README.md": "data.md",
    "Modules/Core/README.md": "core.md",
    "Testing/Support/README.md": "testing-support.md",
}
LANGUAGES = {".py": "python", ".cxx": "c++", ".h": "c++", ".sh": "sh", ".txt": "text", ".json": "json", ".xml": "xml"}
LINK = re.compile(r"(\]\()([^)\s]+)(\))")
FENCE = re.compile(r"^(```|~~~)")
SCRIPT = re.compile(r"(?<![\[`])`([a-z0-9_]+\.py)((?: [^`]*)?)`")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


class Site:
    """The pages that are written, by their path in the project."""

    def __init__(self, folder):
        self.folder = folder
        self.waiting = []
        self.written = {}
        self.scripts = {name: f"Examples/Python/{name}" for name in sorted(os.listdir(f"{ROOT}/Examples/Python"))
                        if name.endswith(".py")}

    def place(self, path):
        """Where a file of the project stands on the site; it is written if it was not yet."""
        if path in self.written:
            return self.written[path]
        if path in PLACES:
            place = PLACES[path]
        elif path.startswith("Documentation/"):
            place = path[len("Documentation/"):]
        elif os.path.isdir(f"{ROOT}/{path}"):
            place = "examples.md" if path.startswith("Examples") else None
        elif path.startswith("Modules/") and path.endswith(".h"):
            place = "api/files.html"
        else:
            place = "sources/" + path + ".md"
        self.written[path] = place
        if place and place.endswith(".md"):
            self.waiting.append(path)
        elif place and not place.startswith("api/"):
            self.save(place, path)
        return place

    def save(self, place, path):
        """Copy a file as it is."""
        target = os.path.join(self.folder, place)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copyfile(os.path.join(ROOT, path), target)

    def link(self, target, path, place):
        """A link of the page `path`, which stands at `place`, as it holds on the site."""
        if re.match(r"[a-z]+:|#", target):
            return target
        name, _, anchor = target.partition("#")
        wanted = os.path.normpath(os.path.join(os.path.dirname(path), name)).replace(os.sep, "/")
        if not os.path.exists(f"{ROOT}/{wanted}"):
            raise SystemExit(f"{path}: nothing at {target}")
        found = self.place(wanted)
        if not found:
            raise SystemExit(f"{path}: the site has no page for the folder {target}")
        return os.path.relpath(found, os.path.dirname(place) or ".") + ("#" + anchor if anchor else "")

    def markdown(self, path, place):
        """A page of the project with its links made to hold."""
        lines = []
        fenced = False
        for line in read(path).split("\n"):
            if FENCE.match(line.strip()):
                fenced = not fenced
            elif not fenced:
                line = LINK.sub(lambda match: match[1] + self.link(match[2], path, place) + match[3], line)
                line = SCRIPT.sub(lambda match: self.script(match, place), line)
            lines.append(line)
        return "\n".join(lines)

    def script(self, match, place):
        """The name of an example, as a link to it."""
        if match[1] not in self.scripts:
            return match[0]
        found = os.path.relpath(self.place(self.scripts[match[1]]), os.path.dirname(place) or ".")
        return f"[`{match[1]}{match[2]}`]({found})"

    def source(self, path):
        """A page that shows a source file."""
        text = read(path)
        fence = "````" if "```" in text else "```"
        language = LANGUAGES.get(os.path.splitext(path)[1], "text")
        return f"# {os.path.basename(path)}\n\n`{path}`\n\n{fence}{language}\n{text.rstrip()}\n{fence}\n"

    def examples(self):
        """The page that lists the examples, each with the first line of what it says of itself."""
        lines = ["# Examples", "", "Each is run by the tests. `--help` says what it takes.", ""]
        for path in self.scripts.values():
            match = re.search(r'"""(.+?)(\n\n|""")', read(path), re.S)
            about = " ".join(match[1].split()) if match else ""
            lines.append(f"- [{os.path.basename(path)}]({self.place(path)}): {about}")
        return "\n".join(lines) + "\n"

    def write(self):
        """Write what waits, until nothing does."""
        while self.waiting:
            path = self.waiting.pop()
            place = self.written[path]
            if os.path.isdir(f"{ROOT}/{path}"):
                text = self.examples()
            elif path.endswith(".md"):
                text = self.markdown(path, place)
            else:
                text = self.source(path)
            target = os.path.join(self.folder, place)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            with open(target, "w", encoding="utf-8") as file:
                file.write(text)

    def navigation(self):
        """The tree of pages: in the order of Documentation/README.md."""
        contents = read("Documentation/README.md")
        guide = [{title: self.place(f"Documentation/{page}")}
                 for title, page in re.findall(r"^\d+\. \[([^\]]+)\]\(([^)]+)\)", contents, re.M)]
        filters = [{title: self.place(f"Documentation/{page}")}
                   for title, page in re.findall(r"^- \[([^\]]+)\]\((filters/[^)]+)\)", contents, re.M)]
        notes = [self.place("Documentation/notes/README.md")]
        notes += [self.place(f"Documentation/notes/{name}") for name in sorted(os.listdir(f"{ROOT}/Documentation/notes"))
                  if name.endswith(".md") and name != "README.md"]
        examples = [self.place("Examples/Python")] + [{name: self.place(path)} for name, path in self.scripts.items()]
        return [{"Home": self.place("README.md")}, {"Guide": [self.place("Documentation/README.md")] + guide},
                {"Filters": filters}, {"Examples": examples}, {"Notes": notes}, {"C++ reference": "api/index.html"},
                {"Project": [{"What is new": self.place("CHANGELOG.md")}, {"Contributing": self.place("CONTRIBUTING.md")},
                             {"Security": self.place("SECURITY.md")},
                             {"Core": self.place("Modules/Core/README.md")}, {"Meshes": self.place("Data/README.md")}]}]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", help="folder to write to: pages in it, and mkdocs.yml beside them")
    arguments = parser.parse_args()
    pages = os.path.join(arguments.folder, "pages")
    shutil.rmtree(pages, ignore_errors=True)
    os.makedirs(pages)

    site = Site(pages)
    navigation = site.navigation()
    site.write()
    shutil.copyfile(os.path.join(HERE, "site.css"), os.path.join(pages, "site.css"))
    # MkDocs is to find what Doxygen writes into the same place afterwards.
    os.makedirs(os.path.join(pages, "api"))
    for name in ("index.html", "files.html"):
        with open(os.path.join(pages, "api", name), "w", encoding="utf-8") as file:
            file.write("<!-- Doxygen's page takes this place. -->\n")
    with open(os.path.join(HERE, "mkdocs.yml"), encoding="utf-8") as file:
        configuration = file.read()
    configuration += f"docs_dir: pages\nsite_dir: html\nnav: {json.dumps(navigation)}\n"
    with open(os.path.join(arguments.folder, "mkdocs.yml"), "w", encoding="utf-8") as file:
        file.write(configuration)
    print(f"{len(site.written)} pages and pictures in {pages}")


if __name__ == "__main__":
    main()
