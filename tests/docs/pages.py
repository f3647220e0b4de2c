"""The pages of the documentation: their fenced blocks, links and anchors."""

import os
import pathlib
import re
from typing import NamedTuple

SOURCE = pathlib.Path(os.environ["PREHEND_SOURCE"])


class Block(NamedTuple):
    language: str  # "sh", "text", "json", ...; empty where none is stated
    text: str
    line: int  # of its first line in the page
    reason: str  # why it is not run, from the comment <!-- not run: REASON --> above it, or empty


def pages():
    """The first page and all pages in docs, in a fixed order."""
    return [SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md"))]


def name_of(page):
    return str(page.relative_to(SOURCE))


def blocks(page):
    """The fenced blocks of a page, in their order."""
    found = []
    lines = page.read_text().splitlines()
    at = 0
    while at < len(lines):
        fence = re.fullmatch(r"```(\w*)", lines[at])
        if fence is None:
            at += 1
            continue
        end = lines.index("```", at + 1)
        above = lines[at - 1] if at > 0 else ""
        comment = re.fullmatch(r"<!-- not run: (.+) -->", above)
        reason = comment.group(1) if comment else ""
        found.append(Block(fence.group(1), "\n".join(lines[at + 1 : end]) + "\n", at + 2, reason))
        at = end + 1
    return found


def prose(page):
    """The text of a page without its fenced blocks and without code between backticks."""
    text = re.sub(r"(?ms)^```.*?^```$", "", page.read_text())
    return re.sub(r"`[^`\n]*`", "``", text)


def links(page):
    """The targets of the links and pictures of a page."""
    return re.findall(r"\]\(([^)\s]+)\)", prose(page))


def anchors(page):
    """The anchors of the headings of a page, as GitHub makes them."""
    text = re.sub(r"(?ms)^```.*?^```$", "", page.read_text())
    made = set()
    for heading in re.findall(r"(?m)^#+ (.+)$", text):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
        anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        repeated = 0
        while anchor + (f"-{repeated}" if repeated else "") in made:
            repeated += 1
        made.add(anchor + (f"-{repeated}" if repeated else ""))
    return made
