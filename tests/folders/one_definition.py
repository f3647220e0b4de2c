"""No two files define different types under one name.

The linker keeps one of two functions of the same name without a word, the destructor of another
class as well: a program then leaks or writes to what is not there. No compiler sees that, since no
unit needs to include both files.
    python3 one_definition.py SOURCE
"""

import collections
import pathlib
import re
import sys

FOLDERS = ("sim", "primitives", "planner", "benchmarks", "tests")

# What matters of a file: where names begin and end. Comments and texts are passed over.
TOKEN = re.compile(
    r"""(?P<skipped>//[^\n]*|/\*.*?\*/|R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"
        |(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+')
    |(?P<anonymous>\bnamespace\s*\{)
    |\bnamespace\s+(?P<namespace>[\w:]+)\s*\{
    |\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(?P<type>[\w:]+)(?:\s+final)?
        (?:\s*:[^;{()=]*)?\s*\{
    |(?P<other>[{}])""",
    re.S | re.X,
)


def types_of(text):
    """Yields the full name of each type that the text defines and that all units see."""
    inside = []  # None: a function or a type, where what is defined is not looked at
    for token in TOKEN.finditer(text):
        if token["skipped"]:
            continue
        if token["other"] == "}":
            if inside:
                inside.pop()
        elif token["type"]:
            if None not in inside:
                yield "::".join([*inside, token["type"]])
            inside.append(None)
        else:
            inside.append(token["namespace"])


def sources(source):
    for folder in FOLDERS:
        for file in sorted((source / folder).rglob("*")):
            if file.suffix in (".h", ".cpp") and "node_modules" not in file.parts:
                yield file


def main(source):
    files = collections.defaultdict(set)
    for file in sources(source):
        for name in types_of(file.read_text(encoding="utf-8")):
            files[name].add(file.relative_to(source).as_posix())
    several = {name: sorted(where) for name, where in files.items() if len(where) > 1}
    for name, where in sorted(several.items()):
        print(f"{name} is defined in {' and in '.join(where)}")
    if not files:
        print(f"no type was found in {source}")
    return 1 if several or not files else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
