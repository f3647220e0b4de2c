"""The command prehend of an installed wheel: the program that stands in its folder bin."""

import os
import pathlib
import sys


def main() -> None:
    program = pathlib.Path(__file__).parent / "bin" / "prehend"
    os.execv(program, [str(program), *sys.argv[1:]])
