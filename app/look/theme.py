"""The window's colours, spacing and type, in a light and a dark set."""

from dataclasses import dataclass

from PySide6.QtGui import QColor, QFont, QPalette

UNIT = 8
"""All distances are multiples or halves of it, in device-independent pixels."""


@dataclass(frozen=True, slots=True)
class Theme:
    """Colours by what they are for."""

    window: str
    panel: str
    raised: str
    line: str
    text: str
    quiet: str
    accent: str
    on_accent: str
    hover: str
    danger: str
    danger_ground: str
    view: str


LIGHT = Theme(
    window="#eef0f3",
    panel="#ffffff",
    raised="#f5f6f8",
    line="#d8dce2",
    text="#1c222b",
    quiet="#5d6673",
    accent="#0067b8",
    on_accent="#ffffff",
    hover="#e3e9f0",
    danger="#9d1c1c",
    danger_ground="#fdecec",
    view="#f7f8fa",
)
DARK = Theme(
    window="#14161a",
    panel="#1e2127",
    raised="#262a31",
    line="#343942",
    text="#e6e9ee",
    quiet="#9aa4b2",
    accent="#4aa8ff",
    on_accent="#06131f",
    hover="#2e343d",
    danger="#ffb3b3",
    danger_ground="#43211f",
    view="#181a1f",
)


def theme(dark: bool) -> Theme:
    """Return the dark or the light set."""
    return DARK if dark else LIGHT


def qt_palette(colours: Theme) -> QPalette:
    """Return the set as a palette for widgets the style sheet does not name."""
    palette = QPalette()
    roles = {
        QPalette.ColorRole.Window: colours.window,
        QPalette.ColorRole.Base: colours.panel,
        QPalette.ColorRole.AlternateBase: colours.raised,
        QPalette.ColorRole.Button: colours.panel,
        QPalette.ColorRole.WindowText: colours.text,
        QPalette.ColorRole.Text: colours.text,
        QPalette.ColorRole.ButtonText: colours.text,
        QPalette.ColorRole.PlaceholderText: colours.quiet,
        QPalette.ColorRole.Highlight: colours.accent,
        QPalette.ColorRole.HighlightedText: colours.on_accent,
        QPalette.ColorRole.ToolTipBase: colours.raised,
        QPalette.ColorRole.ToolTipText: colours.text,
        QPalette.ColorRole.Link: colours.accent,
        QPalette.ColorRole.Mid: colours.line,
    }
    for role, colour in roles.items():
        palette.setColor(role, QColor(colour))
    for role in (QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(colours.quiet))
    return palette


def tabular(font: QFont) -> QFont:
    """Return the font with digits of equal width, where it has them."""
    even = QFont(font)
    even.setFeature(QFont.Tag("tnum"), 1)
    return even


def style_sheet(c: Theme) -> str:
    """Return the style sheet of the whole window."""
    return f"""
    QWidget {{ color: {c.text}; }}
    QMainWindow, QDialog {{ background: {c.window}; }}
    QMainWindow::separator {{ background: {c.window}; width: 8px; height: 8px; }}
    QMenuBar {{ background: {c.panel}; padding: 2px 4px; }}
    QMenuBar::item {{ padding: 4px 8px; border-radius: 4px; background: transparent; }}
    QMenuBar::item:selected {{ background: {c.hover}; }}
    QMenu {{ background: {c.panel}; border: 1px solid {c.line}; padding: 4px; }}
    QMenu::item {{ padding: 6px 24px 6px 16px; border-radius: 4px; }}
    QMenu::item:selected {{ background: {c.hover}; color: {c.text}; }}
    QMenu::item:disabled {{ color: {c.quiet}; }}
    QMenu::separator {{ height: 1px; background: {c.line}; margin: 4px 8px; }}
    QToolBar {{ background: {c.panel}; border: none; border-bottom: 1px solid {c.line};
        spacing: 8px; padding: 8px; }}
    QToolBar::separator {{ background: {c.line}; width: 1px; margin: 4px 4px; }}
    QStatusBar {{ background: {c.panel}; border-top: 1px solid {c.line}; color: {c.quiet}; }}
    QStatusBar::item {{ border: none; }}
    QStatusBar QLabel {{ color: {c.quiet}; }}
    QToolTip {{ background: {c.raised}; color: {c.text}; border: 1px solid {c.line};
        padding: 6px 8px; }}
    QPushButton, QToolButton {{ background: {c.panel}; border: 1px solid {c.line};
        border-radius: 6px; padding: 5px 12px; }}
    QPushButton:hover, QToolButton:hover {{ background: {c.hover}; }}
    QPushButton:focus, QToolButton:focus, QLineEdit:focus {{ border-color: {c.accent}; }}
    QPushButton:disabled, QToolButton:disabled {{ color: {c.quiet}; }}
    QPushButton:checked, QToolButton:checked {{ background: {c.accent}; color: {c.on_accent};
        border-color: {c.accent}; }}
    QPushButton[kind="primary"] {{ background: {c.accent}; color: {c.on_accent};
        border-color: {c.accent}; font-weight: 600; }}
    QToolButton[kind="plain"], QPushButton[kind="plain"] {{ background: transparent;
        border: 1px solid transparent; padding: 3px 6px; }}
    QToolButton[kind="plain"]:hover, QPushButton[kind="plain"]:hover {{ background: {c.hover}; }}
    QToolButton[kind="plain"]:focus, QPushButton[kind="plain"]:focus {{
        border-color: {c.accent}; }}
    QToolButton[kind="small"] {{ background: transparent; border: 1px solid transparent;
        padding: 2px 4px; }}
    QToolButton[kind="small"]:hover {{ background: {c.hover}; }}
    QToolButton[kind="small"]:focus {{ border-color: {c.accent}; }}
    QToolButton[segment="first"] {{ border-top-right-radius: 0; border-bottom-right-radius: 0; }}
    QToolButton[segment="last"] {{ border-top-left-radius: 0; border-bottom-left-radius: 0;
        border-left: none; }}
    QCheckBox::indicator:unchecked {{ border: 1px solid {c.quiet}; border-radius: 2px;
        background: {c.panel}; width: 12px; height: 12px; }}
    QLineEdit {{ background: {c.panel}; border: 1px solid {c.line};
        border-radius: 6px; padding: 5px 8px; selection-background-color: {c.accent};
        selection-color: {c.on_accent}; }}
    QWidget#panel {{ background: {c.panel}; }}
    QDockWidget {{ color: {c.text}; }}
    QDockWidget::title {{ background: {c.panel}; padding: 8px 12px; text-align: left;
        border-bottom: 1px solid {c.line}; }}
    QPushButton::menu-indicator {{ image: none; width: 0; }}
    QTabBar {{ qproperty-drawBase: 0; }}
    QTabBar::tab {{ background: {c.window}; color: {c.quiet}; padding: 6px 14px;
        border: none; border-bottom: 2px solid transparent; }}
    QTabBar::tab:selected {{ background: {c.panel}; color: {c.text};
        border-bottom: 2px solid {c.accent}; }}
    QTabBar::tab:hover {{ color: {c.text}; }}
    QHeaderView::section {{ background: {c.panel}; color: {c.quiet}; border: none;
        border-bottom: 1px solid {c.line}; padding: 6px 4px; font-weight: 400; }}
    QTableView, QTreeView, QListView {{ background: {c.panel}; border: none;
        gridline-color: {c.line}; alternate-background-color: {c.raised};
        selection-background-color: {c.hover}; selection-color: {c.text}; outline: none; }}
    QTreeView::item {{ padding: 2px 4px; }}
    QTableView::item {{ padding: 2px 4px; }}
    QProgressBar {{ background: {c.hover}; border: none; border-radius: 3px; height: 6px;
        max-height: 6px; }}
    QProgressBar::chunk {{ background: {c.accent}; border-radius: 3px; }}
    QScrollArea {{ border: none; background: {c.panel}; }}
    QScrollArea > QWidget > QWidget {{ background: {c.panel}; }}
    QScrollBar:vertical {{ background: transparent; width: 10px; margin: 0; }}
    QScrollBar:horizontal {{ background: transparent; height: 10px; margin: 0; }}
    QScrollBar::handle {{ background: {c.line}; border-radius: 4px; margin: 1px;
        min-height: 24px; min-width: 24px; }}
    QScrollBar::handle:hover {{ background: {c.quiet}; }}
    QScrollBar::add-line, QScrollBar::sub-line, QScrollBar::add-page, QScrollBar::sub-page {{
        background: none; border: none; width: 0; height: 0; }}
    QFrame#view {{ background: {c.view}; border: 1px solid {c.line}; border-radius: 6px; }}
    QWidget#viewTitle {{ background: {c.panel}; border-top-left-radius: 6px;
        border-top-right-radius: 6px; border-bottom: 1px solid {c.line}; }}
    QLabel#title {{ font-weight: 600; }}
    QLabel[kind="quiet"] {{ color: {c.quiet}; }}
    QLabel[kind="heading"] {{ color: {c.quiet}; font-weight: 600; }}
    QFrame#banner {{ background: {c.danger_ground}; border: 1px solid {c.danger};
        border-radius: 6px; }}
    QFrame#banner QLabel {{ color: {c.danger}; }}
    QFrame#banner[kind="note"] {{ background: {c.raised}; border-color: {c.line}; }}
    QFrame#banner[kind="note"] QLabel {{ color: {c.text}; }}
    QFrame#card {{ background: {c.raised}; border-radius: 6px; }}
    """
