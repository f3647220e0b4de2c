"""Where public classes say that they are from."""

from __future__ import annotations


def show_in(module: str, *classes: type) -> None:
    """Says that the classes are of a public module, wherever they were made: help() shows it."""
    for one in classes:
        one.__module__ = module
