"""Every block of commands in the documentation is run as it stands, page by page, in an empty folder
that looks like a checkout: `./run` calls the program that was built. A block that cannot be run
stands below <!-- not run: REASON -->; its reason is printed."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from pages import SOURCE, blocks, name_of, pages

PROGRAM = os.environ["PREHEND_PROGRAM"]

# What `./run` of a checkout does once all is built.
RUN = """#!/bin/sh
if [ "$1" = python ]; then shift; exec "{python}" "$@"; fi
[ $# -gt 0 ] || set -- plan
exec "{program}" "$@"
"""

# What some commands need beside the program, and the variable that says whether it was built.
NEEDED = {"./run python ": "PREHEND_PYTHON_MODULE", "./run learn ": "PREHEND_LEARNS"}


def checkout(folder):
    for name in ("docs", "robots", "benchmarks", "tests"):
        (folder / name).symlink_to(SOURCE / name)
    run = folder / "run"
    run.write_text(RUN.format(program=PROGRAM, python=sys.executable))
    run.chmod(0o755)


def run_block(block, folder):
    environment = {k: v for k, v in os.environ.items() if "DISPLAY" not in k}
    return subprocess.run(
        ["bash", "-eu", "-o", "pipefail", "-c", block.text],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=600,
    )


class Commands(unittest.TestCase):
    """One test a page, made below."""

    def run_page(self, page):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            checkout(folder)
            for block in blocks(page):
                if block.language != "sh":
                    continue
                if block.reason:
                    print(f"{name_of(page)}:{block.line} not run: {block.reason}")
                    continue
                for command, built in NEEDED.items():
                    if command in block.text and not os.environ.get(built):
                        self.skipTest(f"{command.strip()} was not built")
                done = run_block(block, folder)
                where = f"{name_of(page)}:{block.line}\n{block.text}"
                self.assertEqual(done.returncode, 0, f"{where}\n{done.stdout}\n{done.stderr}")


def add_tests():
    for page in pages():
        if not any(block.language == "sh" for block in blocks(page)):
            continue
        name = "test_" + re.sub(r"\W", "_", name_of(page).removesuffix(".md"))
        setattr(Commands, name, lambda self, page=page: self.run_page(page))


add_tests()


class Harness(unittest.TestCase):
    def test_a_command_that_fails_is_seen(self):
        for text in ("./run plan no_such_scene\n", "false | cat\n", "false\ntrue\n"):
            with tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                checkout(folder)
                block = blocks(SOURCE / "README.md")[0]._replace(text=text)
                self.assertNotEqual(run_block(block, folder).returncode, 0, text)


if __name__ == "__main__":
    unittest.main()
