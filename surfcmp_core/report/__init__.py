"""From a comparison to the files a person or a program reads."""

from surfcmp_core.report.document import make_document
from surfcmp_core.report.outputs import WRITERS, OutputError, check_outputs, write_outputs

__all__ = ["WRITERS", "OutputError", "check_outputs", "make_document", "write_outputs"]
