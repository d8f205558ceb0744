"""Reads a page of `trunk report` without a browser: its contents as JSON, with numpy arrays where it refers to them."""

import base64
import gzip
import json
import re

import numpy as np

TYPES = {"f8": "<f8", "f4": "<f4", "i4": "<i4", "i2": "<i2", "u1": "u1"}


def resolved(value, block):
    if isinstance(value, list):
        return [resolved(v, block) for v in value]
    if not isinstance(value, dict):
        return value
    if set(value) == {"as", "at", "n"}:
        return np.frombuffer(block, TYPES[value["as"]], value["n"], value["at"])
    return {k: resolved(v, block) for k, v in value.items()}


class ReportPage:
    def __init__(self, path):
        self.html = path.read_text(encoding="utf-8")
        self.size = path.stat().st_size
        self.scripts = re.findall(r"<script([^>]*)>(.*?)</script>", self.html, re.S)
        contents, numbers = (self.element(name) for name in ("contents", "numbers"))
        self.contents = resolved(json.loads(contents), gzip.decompress(base64.b64decode(numbers, validate=True)))
        self.files = self.contents["files"]

    def element(self, name):
        found = [text for attributes, text in self.scripts if f'id="{name}"' in attributes]
        if len(found) != 1:
            raise AssertionError(f"{len(found)} elements {name}")
        return found[0]


def positions_m(trajectory):
    """[frames, particles, 3]: the differences added up modulo 2^16."""
    packed = trajectory["positions"]
    differences = packed["differences"].reshape(trajectory["frames"], trajectory["particles"], 3)
    with np.errstate(over="ignore"):
        steps = np.cumsum(differences, axis=0, dtype=np.int16)
    return np.array(packed["origin_m"]) + packed["step_m"] * steps.astype(float)


def named(entries, name):
    return next(e for e in entries if e["name"] == name)
