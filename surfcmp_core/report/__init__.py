"""From a comparison to the files a person or a program reads."""

from surfcmp_core.report.outputs import WRITERS, check_outputs, write_outputs
from surfcmp_core.report.record import make_record
from surfcmp_core.system.whole_files import OutputError

__all__ = ["WRITERS", "OutputError", "check_outputs", "make_record", "write_outputs"]
