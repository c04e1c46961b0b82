#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every message of the modules stands in Documentation/6-errors.md with its own words.

A message is a string of three words or more in the sources of a module: what vtkErrorMacro and vtkWarningMacro say, and the
sentences and exceptions of Core. Where it is put together of pieces around numbers and names each such piece must be
there. The page writes *n* for a number; a digit in the source matches it too.
"""

import re

import sourcetree

PAGE = "Documentation/6-errors.md"
SOURCES = r"Modules/(Core|Data|Sources|Filters|Imaging|Words|Page)/(?!Testing/).*\.(cxx|h)"
TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|'(?:\\.|[^'\\\n])+'|(\"(?:\\.|[^\"\\\n])*\"(?:\s*\"(?:\\.|[^\"\\\n])*\")*)", re.DOTALL)


def literals(source):
    """Strings of a C++ source, adjacent ones joined, with the line on which they begin."""
    source = re.sub(r"^[ \t]*#[ \t]*include[^\n]*", "", source, flags=re.MULTILINE)
    for match in TOKEN.finditer(source):
        if match.group(1):
            parts = re.findall(r"\"((?:\\.|[^\"\\\n])*)\"", match.group(1))
            yield source.count("\n", 0, match.start()) + 1, "".join(parts).replace('\\"', '"')


def plain(text):
    """Without marks of Markdown, line ends, and numbers."""
    text = re.sub(r"[*`\\]", "", text)
    return re.sub(r"\b\d+\b", "n", re.sub(r"\s+", " ", text)).strip(" .:;,")


def faults(root):
    page = plain(sourcetree.text(root, PAGE)) if PAGE in set(sourcetree.files(root)) else ""
    for path in sourcetree.files(root):
        if re.fullmatch(SOURCES, path):
            for line, text in literals(sourcetree.text(root, path)):
                if len(re.findall(r"[A-Za-z']{2,}", text)) >= 3 and plain(text) not in page:
                    yield f"{path}:{line}: {PAGE} lacks '{text}'"


if __name__ == "__main__":
    sourcetree.main(faults)
