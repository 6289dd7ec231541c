#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes each input of a corpus, a line of hexadecimal digits, to a file of its own.

  scripts/unpack_corpus.py CORPUS FOLDER
"""

import hashlib
import pathlib
import sys

corpus, folder = map(pathlib.Path, sys.argv[1:])
for line in corpus.read_text().split("\n") if corpus.exists() else []:
    if line and not line.startswith("#"):
        data = bytes.fromhex(line)
        (folder / hashlib.sha1(data).hexdigest()).write_bytes(data)
