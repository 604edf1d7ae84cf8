"""Processes, and those that they start, whose every step towards a network is written down."""

import os
from pathlib import Path

WATCH = """
import sys

def watch(event, arguments):
    if not event.startswith(("socket.", "urllib.", "http.", "ftplib.", "smtplib.")):
        return
    if event in {"socket.gethostname", "socket.sethostname"}:
        return
    if event == "socket.__new__" and getattr(arguments[1], "name", "") == "AF_UNIX":
        return
    if event == "socket.connect" and isinstance(arguments[1], (str, bytes)):  # a local one
        return
    with open(REPORT, "a") as report:
        print(event, arguments[1:], file=report)
    raise PermissionError("no network here")

sys.addaudithook(watch)
"""


def watched(folder: Path) -> dict[str, str]:
    """Give the environment of a process to be watched; what is seen goes into the folder."""
    report = folder / "network.txt"
    report.touch()
    (folder / "sitecustomize.py").write_text(f"REPORT = {str(report)!r}\n" + WATCH)
    path = [str(folder), str(Path(__file__).parents[1])]
    return os.environ | {"PYTHONPATH": os.pathsep.join(path)}


def seen(folder: Path) -> str:
    return (folder / "network.txt").read_text()
