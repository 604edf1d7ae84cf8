"""Undo and redo as a list of documents."""

from app.model.document import Document


class History:
    """The documents so far, and which of them is current."""

    def __init__(self, first: Document) -> None:
        self._documents = [first]
        self._index = 0

    @property
    def current(self) -> Document:
        """The document in force."""
        return self._documents[self._index]

    @property
    def can_undo(self) -> bool:
        """Whether an earlier document exists."""
        return self._index > 0

    @property
    def can_redo(self) -> bool:
        """Whether a later document exists."""
        return self._index + 1 < len(self._documents)

    def push(self, document: Document) -> bool:
        """Make `document` current and forget what was undone; say whether anything changed."""
        if document == self.current:
            return False
        del self._documents[self._index + 1 :]
        self._documents.append(document)
        self._index += 1
        return True

    def drop(self) -> Document:
        """Forget the current document, as one that came to nothing, and all after it."""
        if self._index:
            del self._documents[self._index :]
            self._index -= 1
        return self.current

    def undo(self) -> Document:
        """Step back and return the document now current."""
        self._index = max(self._index - 1, 0)
        return self.current

    def redo(self) -> Document:
        """Step forward and return the document now current."""
        self._index = min(self._index + 1, len(self._documents) - 1)
        return self.current
