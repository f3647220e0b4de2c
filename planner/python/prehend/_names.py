"""Enumerations of C++ as strings, and where public classes say that they are from."""

from __future__ import annotations

import enum


class NamedEnum(str, enum.Enum):
    """An enumeration of C++. Its members are strings as well: Outcome.stable == "stable"."""

    def __str__(self) -> str:
        return str(self.value)


def show_in(module: str, *classes: type) -> None:
    """Says that the classes are of a public module, wherever they were made: help() shows it."""
    for one in classes:
        one.__module__ = module
