"""What the window shows and how it came about, as frozen data."""

from app.model.document import Document, Source
from app.model.history import History
from app.model.view_state import Heatmap, Scale, ViewState

__all__ = ["Document", "Heatmap", "History", "Scale", "Source", "ViewState"]
