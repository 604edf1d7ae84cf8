"""What a command said."""

import pytest


def lines(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """Give what was said on standard error, line by line."""
    return capsys.readouterr().err.splitlines()
