"""The guide, the list of shortcuts, and what the program is for."""

from collections.abc import Sequence
from html import escape
from importlib.metadata import version

from PySide6.QtCore import QBuffer, QIODevice, Qt
from PySide6.QtGui import QAction, QIcon, QImage
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget

from app.look.theme import UNIT
from app.panels.command_palette import plain

PICTURE_WIDTH = 420


class HelpDialog(QDialog):
    """A page to read; it does not block the window."""

    def __init__(self, parent: QWidget, title: str, page: str) -> None:
        super().__init__(parent)
        self.setWindowTitle(title)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(84 * UNIT, 80 * UNIT)
        self.page = QTextBrowser()
        self.page.setAccessibleName(title)
        self.page.document().setDocumentMargin(2 * UNIT)
        self.page.setHtml(page)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        buttons.button(QDialogButtonBox.StandardButton.Close).setIcon(QIcon())
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT, UNIT, UNIT)
        column.addWidget(self.page)
        column.addWidget(buttons)


class HelpPages(QWidget):
    """Writes the pages; a widget only for its translations."""

    def guide(self, pictures: Sequence[QImage]) -> str:
        """Return the guide, with pictures of the four views as they are now."""
        views = [
            (
                self.tr("Surface 1 and surface 2"),
                self.tr(
                    "The two surfaces as they were measured, each with the triangulation of its"
                    " own nodes. Pale places have no data."
                ),
            ),
            None,
            (
                self.tr("United triangulation"),
                self.tr(
                    "One triangulation over the nodes of both. Where nodes of both mix, triangles"
                    " form chains, each in its own colour: closed ones are warm, open ones cool."
                    " Where nodes of one surface are alone, they lie in its quiet colour."
                ),
            ),
            (
                self.tr("Difference"),
                self.tr(
                    "How far surface 1 lies above surface 2 (or, as absolute difference, from it)."
                    " Grey was not compared. The colours' range stays as you set it."
                ),
            ),
        ]
        first = self.tr(
            "Drop two files on the window, or one on a surface's place. The four views turn"
            " together: drag to turn, drag with the right button to move, wheel to zoom,"
            " double-click to let one view fill the window."
        )
        parts = ["<h2>", self.tr("Compare two surfaces"), "</h2><p>", first, "</p>"]
        for k, view in enumerate(views):
            if view is not None:
                parts.append(f"<h3>{view[0]}</h3><p>{view[1]}</p>")
            if k < len(pictures):
                parts.append(f"<p>{_picture(pictures[k])}</p>")
        for title, text in self._advice():
            parts.append(f"<h3>{title}</h3><p>{text}</p>")
        return "".join(parts)

    def _advice(self) -> tuple[tuple[str, str], ...]:
        """Return titles and texts of what comes after the views."""
        return (
            (
                self.tr("Can I trust the colour?"),
                self.tr(
                    "Choose the trust map: green triangles rest on nodes of both surfaces; the"
                    " others were filled in for one of the two. Coverage, in the line at the"
                    " bottom, says how much of each surface was compared."
                ),
            ),
            (
                self.tr("Which number?"),
                self.tr(
                    "Mean |d|, the 95th percentile and the share within a tolerance can be compared"
                    " between pairs. The paper's sums fall when a scan is thinned, whatever the"
                    " surfaces do. The signed mean flatters: above and below cancel. Every number"
                    " says what it means when the mouse rests on it."
                ),
            ),
            (
                self.tr("Look closer"),
                self.tr(
                    "Click a place to read its values; K keeps the label. Drag over the histogram"
                    " to light up a range of differences. Click a chain in its table to fly there."
                ),
            ),
            (
                self.tr("Part by part"),
                self.tr(
                    "Draw around a region with the lasso or paint it with the brush; with Shift"
                    " held, both take away. Each region has its own measures and its weight, and"
                    " all parts add up to the whole."
                ),
            ),
            (
                self.tr("Are the two aligned?"),
                self.tr(
                    "Where the surfaces do not lie on each other, pick three or more pairs of"
                    " landmarks, then let the best fit finish it, on the whole or on a region that"
                    " has not changed. What that changed stands in the same panel."
                ),
            ),
            (
                self.tr("Keep it"),
                self.tr(
                    "Everything can be undone, step by step. A session keeps all of it in one"
                    " file, with the scans in it where you wish. A report (.html, .pdf) has the"
                    " pictures, the numbers and where they come from; names can be hidden."
                ),
            ),
        )

    def shortcuts(self, actions: Sequence[QAction]) -> str:
        """Return the list of keys."""
        rows = [
            f"<tr><td width='320'>{escape(plain(action))}</td><td><b>"
            f"{escape(action.shortcut().toString(action.shortcut().SequenceFormat.NativeText))}"
            "</b></td></tr>"
            for action in actions
            if not action.shortcut().isEmpty()
        ]
        mouse = (
            (self.tr("Turn (relief) or move (map)"), self.tr("drag")),
            (self.tr("Move"), self.tr("drag with the right button, or Shift and drag")),
            (self.tr("Turn with a tool in hand"), self.tr("drag with the right button")),
            (self.tr("Take away from a region"), self.tr("Shift with lasso or brush")),
            (self.tr("Zoom at the pointer"), self.tr("wheel")),
            (self.tr("Values of a place"), self.tr("click")),
            (self.tr("One view alone, and back"), self.tr("double-click")),
            (self.tr("Turn, move, zoom by keys"), self.tr("arrows, Shift and arrows, + and −")),
        )
        rows += [
            f"<tr><td width='320'>{what}</td><td><b>{how}</b></td></tr>" for what, how in mouse
        ]
        title = self.tr("Keys and mouse")
        return f"<h2>{title}</h2><table cellpadding='4'>{''.join(rows)}</table>"

    def about(self) -> str:
        """Return what the program is, and what it is not."""
        return (
            f"<h2>surfcmp {version('surfcmp')}</h2><p>"
            + self.tr(
                "Compares two surfaces z = F(x, y) given on unstructured grids of different"
                " density, after the paper “Measures for Surface Comparison on Unstructured Grids"
                " with Different Density”."
            )
            + "</p><p>"
            + self.tr(
                "For research and teaching. It is not a medical device and must not be used to"
                " decide on the treatment of a patient. Nothing leaves this machine."
            )
            + "</p><p>"
            + self.tr("MIT licence. Colour maps: F. Crameri, Scientific colour maps.")
            + "</p>"
        )


def _picture(image: QImage) -> str:
    """Return an image as a part of a page."""
    small = image.scaledToWidth(PICTURE_WIDTH, Qt.TransformationMode.SmoothTransformation)
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    small.save(buffer, "PNG")  # type: ignore[call-overload]
    data = bytes(buffer.data().toBase64().data()).decode("ascii")
    return f"<img src='data:image/png;base64,{data}'>"
