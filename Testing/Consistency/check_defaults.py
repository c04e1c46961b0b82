#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""For every parameter: documented default = initialiser = default in the ParaView XML = what the Python getter says."""

import importlib
import os
import re
import xml.etree.ElementTree as ElementTree

import sourcetree

SETTER = r"void Set(\w+)\((?:bool|int|double|vtkIdType|vtkTypeBool) \w+\)[^{]*;"
WORDS = {"on": 1.0, "off": 0.0, "true": 1.0, "false": 0.0}


def value(text, enumerators):
    """A default as something to compare: a list of numbers, and of words in lower case without marks."""
    result = []
    for word in re.sub(r"[(){}]", " ", text).replace(",", " ").split():
        word = word.lower()
        try:
            result.append(WORDS[word] if word in WORDS else float(word.rstrip("f")))
        except ValueError:
            name = re.sub(r"[^a-z0-9]", "", word.split("::")[-1])
            result.append(enumerators.get(name, name))
    return result


def parameters(header):
    """(name, documented default or None) of every parameter with a setter, from its ///@{ group."""
    for group in re.findall(r"///@\{(.*?)///@\}", header, re.DOTALL):
        # The help text alone, on one line.
        comment = " ".join(re.findall(r"^\s*(?:///|/?\*+/?)(.*)$", group, re.MULTILINE))
        default = re.search(r"\b[Dd]efault:? +(?:is +)?(\([^)]*\)|[-+\d.e]*\d(?:, [-+\d.e]*\d)*|\w+)", comment)
        for name in re.findall(rf"vtkSet(?:Clamp|Vector\d)?Macro\((\w+)|{SETTER}", group):
            name = name[0] or name[1]
            yield name, default.group(1) if default else None


def initialisers(header):
    """Member name to the text of its default initialiser."""
    members = header[header.rfind("private:"):]
    found = re.findall(r"^ +[\w:<>]+ +(\w+)(?:\[\d+\])? *(?:= *([^;]+)|(\{[^;]*\}));", members, re.MULTILINE)
    return {name: assigned or braces for name, assigned, braces in found}


def enumerators_of(header):
    """Enumerator, and the word for it in SetXToY(), to its number (lower case, no underscores)."""
    blocks = " ".join(re.findall(r"\benum\b[^{;]*\{([^}]*)\}", header))
    result = {name.lower().replace("_", ""): float(number) for name, number in re.findall(r"\b(\w+) = (\d+)", blocks)}
    for word, name in re.findall(r"void Set\w+To(\w+)\(\) \{ this->Set\w+\((\w+)\)", header):
        result.setdefault(word.lower(), result.get(name.lower().replace("_", "")))
    return result


def same(documented, default):
    """Whether the documented values are the default; '-1, 1 on each axis' stands for -1, 1, -1, 1, -1, 1."""
    return documented * (len(default) // max(len(documented), 1)) == default


def xml_defaults(root, name):
    """Parameter to the default in the XML, for a class."""
    for path in sourcetree.files(root):
        if re.fullmatch(r"Modules/ParaViewPlugin/\w+\.xml", path):
            for proxy in ElementTree.fromstring(sourcetree.text(root, path)).iter():
                if proxy.get("class") == name:
                    for item in proxy:
                        command = item.get("command", "")
                        if command.startswith("Set") and item.get("default_values", "none") != "none":
                            yield command[3:], item.get("default_values")


def faults(root):
    try:
        package = importlib.import_module("shadowcones")
    except ImportError:
        package = None
        yield "the Python package 'shadowcones' is not on PYTHONPATH"
    for module, name in [*sourcetree.classes(root), *sourcetree.classes(root, "helpers")]:
        path = f"Modules/{module}/{name}.h"
        if not os.path.exists(os.path.join(root, path)):
            continue
        header = sourcetree.text(root, path)
        enumerators = enumerators_of(header)
        members = {key: value(text, enumerators) for key, text in initialisers(header).items()}
        xml = dict(xml_defaults(root, name))
        instance = getattr(package, name)() if hasattr(package, name) else None
        for parameter, documented in parameters(header):
            if parameter not in members:
                yield f"{path}: {parameter} has no default initialiser"
                continue
            default = members[parameter]
            if documented is None:
                yield f"{path}: {parameter} has no documented default"
            elif not same(value(documented, enumerators), default):
                yield f"{path}: {parameter} is documented as {documented} and initialised to {default}"
            if parameter in xml and not same(value(xml[parameter], enumerators), default):
                yield f"{name}: the XML says {xml[parameter]} for {parameter}, the header {default}"
            if instance is not None:
                got = getattr(instance, "Get" + parameter)()
                got = value(got, {}) if isinstance(got, str) else [float(v) for v in (got if isinstance(got, tuple) else (got,))]
                if got != default:
                    yield f"{name}: Get{parameter}() gives {got}, the header says {default}"


if __name__ == "__main__":
    sourcetree.main(faults)
