"""Minimum spanning trees of T1 and T2: they tie clouts together, so that no chain is missed."""

from surfcmp_core.spanning_tree.spanning_tree import spanning_tree, tree_ends

__all__ = ["spanning_tree", "tree_ends"]
