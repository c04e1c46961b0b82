#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The ParaView XML offers each class whole: every parameter, enumerator, input and output port, with the class's own defaults."""

import os
import re
import xml.etree.ElementTree as ElementTree

import sourcetree


def setters_of(kind):
    """Setters that a class adds to its superclasses: name without 'Set'."""
    inherited = set().union(*(dir(base) for base in kind.__mro__[1:]))
    return {name[3:] for name in dir(kind) if name.startswith("Set") and name not in inherited}


SCRIPTED = {"PreparedScene"}  # objects that one filter of a script hands to another


def numbers(values):
    return [float(v) for v in (values if isinstance(values, tuple) else (values,))]


# What a text says is measured in, and what the label of the property or of its group must hold then.
UNITS = ((r"\bdegrees\b", "°"), (r"\bworld units?\b", "world unit"), (r"\bpixels\b", "pixel"), (r"\bW m\^-2", "W m⁻²"),
         (r"\b[Mm]inutes\b", "minute"), (r"\blux\b", "lx"))


def panel_faults(proxy):
    """Every property stands in a group, and its unit in its label or the group's. Scripts call it by its name all the same."""
    groups = {}
    for group in proxy.findall("PropertyGroup"):
        if not group.get("label"):
            yield "a group has no label"
        for member in group.findall("Property"):
            groups.setdefault(member.get("name"), []).append(group.get("label", ""))
    items = [item for item in proxy if item.tag.endswith(("VectorProperty", "ProxyProperty")) and not item.get("information_only")]
    for item in items:
        name = item.get("name")
        if name not in groups:
            yield f"{name}: stands in no group"
        text = " ".join(item.findtext("Documentation", "").split())
        for words, unit in UNITS:
            if re.search(words, text) and not any(unit in label for label in [item.get("label", ""), *groups.get(name, [])]):
                yield f"{name}: neither its label nor its group's says {unit}"
        # ParaView's Python takes the letters and digits of the label for the name.
        if item.get("label") and re.sub(r"[^A-Za-z0-9_]", "", item.get("label")) != name:
            yield f"{name}: scripts would have to call it by its label, {item.get('label')}"
    for name in sorted(set(groups) - {item.get("name") for item in items}):
        yield f"{name}: a group names it, and it is no property"


def property_faults(item, instance):
    """What is wrong with one vector property."""
    if item.get("information_only") == "1":
        return  # what ParaView asks, and no one sets
    command = item.get("command", "")
    if not hasattr(instance, command):
        yield f"the class has no {command}()"
        return
    if item.find("Documentation") is None or not item.findtext("Documentation").strip():
        yield "has no documentation"
    if command == "SetInputArrayToProcess":
        # Index, port, connection, association and name: no getter has them.
        given = item.get("default_values", "").split(maxsplit=4)
        if item.get("number_of_elements") != "5" or not 0 <= int(given[1]) < instance.GetNumberOfInputPorts():
            yield "an array is chosen by 5 values, the second an input port"
        return
    if item.tag == "StringVectorProperty":
        return  # a text has no default that could be compared
    if item.get("repeat_command") == "1":
        if item.get("default_values"):
            yield "a list has no default"
        return
    if item.tag == "StringVectorProperty":
        wanted = getattr(instance, "Get" + command[3:])()
        if item.get("default_values") != wanted:
            yield f"the XML says {item.get('default_values')}, the class {wanted}"
        return
    wanted = numbers(getattr(instance, "Get" + command[3:])())
    given = [float(v) for v in item.get("default_values", "").split()]
    if given != wanted:
        yield f"the XML says {given}, the class {wanted}"
    if int(item.get("number_of_elements", "0")) != len(wanted):
        yield f"number_of_elements should be {len(wanted)}"
    for domain in item:
        for kind in ("min", "max"):
            bounds = [float(v) for v in domain.get(kind, "").split()] if domain.tag.endswith("RangeDomain") else []
            if bounds and len(bounds) != len(wanted):
                yield f"{kind} of the range should have {len(wanted)} values"
            if any(bound > value if kind == "min" else bound < value for bound, value in zip(bounds, wanted)):
                yield f"the default lies outside {kind} of the range"


def enumeration_faults(item, instance, setters):
    """Each entry is what SetXToEntry() sets, and each SetXToEntry() has an entry."""
    name = item.get("command")[3:]
    entries = {e.get("text").replace(" ", ""): int(e.get("value")) for e in item.iter("Entry")}
    named = {s[len(name) + 2:] for s in setters if s.startswith(name + "To")}
    if set(entries) != named:
        yield f"the XML has the entries {sorted(entries)}, the class {sorted(named)}"
    for text in sorted(named & set(entries)):
        getattr(instance, f"Set{name}To{text}")()
        if getattr(instance, "Get" + name)() != entries[text]:
            yield f"{text} should be {getattr(instance, 'Get' + name)()}, not {entries[text]}"


def input_faults(proxy, instance, optional_key):
    """One InputProperty a port, in its place, with a setter of its name. A class may ask for more than its ports do."""
    inputs = {int(item.get("port_index", "0")): item for item in proxy.findall("InputProperty")}
    if sorted(inputs) != list(range(instance.GetNumberOfInputPorts())):
        yield f"has inputs for ports {sorted(inputs)}, the class has {instance.GetNumberOfInputPorts()} ports"
        return
    for port, item in inputs.items():
        optional = bool(instance.GetInputPortInformation(port).Get(optional_key))
        if item.find("Hints/Optional") is not None and not optional:
            yield f"{item.get('name')}: optional in the XML and required by the class"
        if port > 0 and not hasattr(instance, f"Set{item.get('name').rstrip('s')}Connection"):
            yield f"{item.get('name')}: the class has no setter of this name"


def proxy_faults(proxy, kind, optional_key):
    """What is wrong with the proxy of a class."""
    vectors = [item for item in proxy if item.tag.endswith("VectorProperty")]
    setters = setters_of(kind)
    for item in vectors:
        # A fresh object each time: setting one enumeration may change another parameter.
        for fault in property_faults(item, kind()):
            yield f"{item.get('name')}: {fault}"
        if item.find("EnumerationDomain") is not None:
            for fault in enumeration_faults(item, kind(), setters):
                yield f"{item.get('name')}: {fault}"
    if proxy.find("Hints/ShowInMenu") is not None:
        yield from panel_faults(proxy)
        for hint in proxy.findall("Hints/ShowInMenu"):
            if hint.get("category") != "Shadow Cones" or hint.get("icon") != f":/ShadowConesIcons/{proxy.get('name')}.svg":
                yield "stands in another category of the menu, or without an icon of its name"
    offered = {item.get("command", "")[3:] for item in proxy if item.get("command")}
    for name in sorted(setters):
        if hasattr(kind, "Get" + name) and name not in offered and name not in SCRIPTED:
            yield f"no property for Set{name}()"
    known = {item.get("name") for item in proxy}
    for decorator in proxy.iter("PropertyWidgetDecorator"):
        if decorator.get("property") not in known:
            yield f"a decorator looks at {decorator.get('property')}, which is no property"
    if optional_key is not None:
        yield from input_faults(proxy, kind(), optional_key)
        if len(proxy.findall("OutputPort")) != kind().GetNumberOfOutputPorts():
            yield f"should name {kind().GetNumberOfOutputPorts()} output ports"


def faults(root):
    import shadowcones
    from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
    from vtkmodules.vtkRenderingCore import vtkCamera

    proxies = {}
    for path in sourcetree.files(root):
        if re.fullmatch(r"Modules/ParaViewPlugin/\w+\.xml", path):
            for group in ElementTree.fromstring(sourcetree.text(root, path)).iter("ProxyGroup"):
                for proxy in group:
                    if proxy.get("class"):
                        proxies.setdefault(proxy.get("class"), []).append((group.get("name"), proxy))
    for _, name in sourcetree.classes(root):
        if len(proxies.get(name, [])) != 1:
            yield f"{name}: has {len(proxies.get(name, []))} proxies, should have 1"
            continue
        group, proxy = proxies[name][0]
        kind = getattr(shadowcones, name)
        place = "filters" if kind().GetNumberOfInputPorts() else "sources"
        if group != (place if kind().GetNumberOfOutputPorts() else "writers"):
            yield f"{name}: stands in the group {group}"
        for fault in proxy_faults(proxy, kind, vtkAlgorithm.INPUT_IS_OPTIONAL()):
            yield f"{name}: {fault}"

    icons = "Modules/ParaViewPlugin/icons/ShadowConesIcons.qrc"
    if icons in sourcetree.files(root):
        listed = {file.text for file in ElementTree.fromstring(sourcetree.text(root, icons)).iter("file")}
        wanted = {hint.get("icon").split("/")[-1] for proxy in [p for ps in proxies.values() for _, p in ps]
                  for hint in proxy.iter("ShowInMenu") if hint.get("icon")}
        there = {os.path.basename(path) for path in sourcetree.files(root) if path.startswith("Modules/ParaViewPlugin/icons/")}
        for name in sorted(wanted ^ listed | listed - there):
            yield f"{name}: an icon is to be shown by a menu, listed in ShadowConesIcons.qrc, and beside it"

    # The camera has more parameters than the image uses: only those that are there are checked.
    for _, proxy in proxies.get("vtkCamera", []):
        for item in proxy:
            if item.get("command"):
                for fault in property_faults(item, vtkCamera()):
                    yield f"vtkCamera: {item.get('name')}: {fault}"


if __name__ == "__main__":
    sourcetree.main(faults)
