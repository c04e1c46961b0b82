#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The examples in the help texts run and give what they say."""

import doctest
import importlib
import os
import pkgutil
import sys
import tempfile

import shadowcones

os.chdir(tempfile.mkdtemp())
tried = failed = 0
for module in pkgutil.iter_modules(shadowcones.__path__):
    if not module.name.startswith("ShadowCones"):
        result = doctest.testmod(importlib.import_module(f"shadowcones.{module.name}"))
        tried, failed = tried + result.attempted, failed + result.failed
print(f"{tried} examples, {failed} failures")
sys.exit(failed > 0 or tried < 10)
