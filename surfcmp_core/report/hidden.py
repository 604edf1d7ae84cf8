"""Results without the files' names and paths, which may be those of patients."""

from dataclasses import replace
from typing import Any

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.report.provenance import base_name
from surfcmp_core.report.record import Record

HIDDEN = "hidden"


def without_names(comparison: Comparison, document: Record) -> tuple[Comparison, Record]:
    """Return both with the files' names and paths replaced wherever they stand; hashes stay."""
    one, two = (
        replace(surface, name=f"surface {k}", path=None)
        for k, surface in enumerate(comparison.surfaces, 1)
    )
    options = dict(document["options"])
    words: dict[str, str] = {}
    for k, (surface, given) in enumerate(
        zip(comparison.surfaces, document["inputs"], strict=True), 1
    ):
        names = [str(surface.path or ""), given["file"], base_name(given["file"]), surface.name]
        words |= {name: f"surface {k}" for name in names if name}
    if options.get("weight"):
        words[options["weight"]] = options["weight"] = HIDDEN
    align = options.get("align")
    if isinstance(align, dict) and "file" in align:
        words[align["file"]] = HIDDEN
        options["align"] = {**align, "file": HIDDEN}
    inputs = [{**given, "file": f"surface {k}"} for k, given in enumerate(document["inputs"], 1)]
    warnings = _without(comparison.warnings, words)
    told = _without(document["warnings"], words)
    comparison = replace(comparison, surfaces=(one, two), warnings=tuple(warnings))
    return comparison, {**document, "inputs": inputs, "options": options, "warnings": told}


def _without(texts: Any, words: dict[str, str]) -> list[str]:
    """Return the texts with each word replaced, the longest first."""
    result = []
    for text in texts:
        for word in sorted(words, key=len, reverse=True):
            text = text.replace(word, words[word])
        result.append(text)
    return result
