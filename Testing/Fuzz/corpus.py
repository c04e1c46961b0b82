#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The corpus as libFuzzer has it, a file an input, and back.

    corpus.py unpack FOLDER            every harness a folder of FOLDER
    corpus.py add HARNESS NAME FILE    one more input, such as one that broke something
"""

import os
import sys

CORPUS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "corpus")


def main(words):
    if len(words) == 2 and words[0] == "unpack":
        for name in os.listdir(CORPUS):
            folder = os.path.join(words[1], os.path.splitext(name)[0])
            os.makedirs(folder, exist_ok=True)
            with open(os.path.join(CORPUS, name), encoding="ascii") as file:
                for line in file:
                    if not line.startswith("#"):
                        label, _, digits = line.strip().partition(" ")
                        with open(os.path.join(folder, label), "wb") as one:
                            one.write(bytes.fromhex(digits))
    elif len(words) == 4 and words[0] == "add":
        with open(words[3], "rb") as one, open(os.path.join(CORPUS, words[1] + ".txt"), "a", encoding="ascii") as file:
            file.write(f"{words[2]} {one.read().hex()}\n")
    else:
        sys.exit(__doc__)


main(sys.argv[1:])
