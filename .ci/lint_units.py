"""Runs clang-tidy on the units that CMake made of the sources, two or more at a time.

    lint_units.py BUILD_FOLDER

Prints what it finds; ends with 1 where it found something. A unit that passed is not looked at again
before something changes that it depends on: its command, a file of the checkout that it includes,
.clang-tidy, lint_scope.cpp, or a package that is installed. BUILD_FOLDER/passed has an empty file for
each such state.
"""
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

HOME = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(sys.argv[1]).resolve()
# What is joined of the library and of the benchmarks; tests are only compiled.
UNITS = re.compile(re.escape(str(BUILD)) + "/(CMakeFiles|benchmarks)/")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
SCOPE_SOURCE = HOME / ".ci/lint_scope.cpp"
SCOPE = BUILD / "lint_scope.so"
NOISE = re.compile(r"^\d+ warnings? generated\.?$|^$")


@functools.cache
def content_and_includes(file):
    """The hash of a file and the files of the checkout, or of the build folder, that it includes."""
    text = file.read_bytes()
    names = INCLUDE.findall(text.decode(errors="replace"))
    found = [next((p for p in (file.parent / name, HOME / name) if p.is_file()), None) for name in names]
    return hashlib.sha256(text).digest(), [p.resolve() for p in found if p]


def files_of(unit):
    """The unit and all that it includes, directly or not."""
    known, waiting = {unit}, [unit]
    while waiting:
        for file in content_and_includes(waiting.pop())[1]:
            if file not in known:
                known.add(file)
                waiting.append(file)
    return sorted(known)


def state_of(unit, command, surroundings):
    state = hashlib.sha256(surroundings + command.encode())
    for file in files_of(unit):
        state.update(str(file).encode() + content_and_includes(file)[0])
    return state.hexdigest()


def surroundings():
    version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True).stdout
    packages = pathlib.Path("/var/lib/dpkg/status")
    parts = [version, *(file.read_bytes() for file in (HOME / ".clang-tidy", SCOPE_SOURCE, packages) if file.exists())]
    return hashlib.sha256(b"\0".join(parts)).digest()


def build_scope():
    """The module of lint_scope.cpp, with the headers that belong to this clang-tidy."""
    headers = pathlib.Path(shutil.which("clang-tidy")).resolve().parent.parent / "include"
    subprocess.run(["clang++", "-std=c++17", "-fno-rtti", "-fPIC", "-shared", f"-isystem{headers}",
                    str(SCOPE_SOURCE), "-o", str(SCOPE)], check=True)


def check(unit):
    """What clang-tidy says of a unit; empty where it passes."""
    run = subprocess.run(["clang-tidy", "-quiet", f"-load={SCOPE}", "-p", str(BUILD), str(unit)], check=False,
                         text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    lines = [line for line in run.stdout.splitlines() if not NOISE.match(line)]
    if run.returncode != 0 and not lines:
        lines = [f"{unit}: clang-tidy ended with {run.returncode}"]
    return "\n".join(lines)


def main():
    passed = BUILD / "passed"
    passed.mkdir(exist_ok=True)
    around = surroundings()
    commands = json.loads((BUILD / "compile_commands.json").read_text())
    states = {pathlib.Path(entry["file"]): entry["command"] for entry in commands if UNITS.match(entry["file"])}
    states = {unit: state_of(unit, command, around) for unit, command in states.items()}
    waiting = [unit for unit, state in states.items() if not (passed / state).exists()]
    # The largest first, so that nothing long is left for one processor at the end.
    waiting.sort(key=lambda unit: sum(file.stat().st_size for file in files_of(unit)), reverse=True)
    print(f"clang-tidy: {len(waiting)} of {len(states)} units, the others passed before", file=sys.stderr)
    if waiting:
        build_scope()
    found = False
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for unit, findings in zip(waiting, pool.map(check, waiting)):
            if findings:
                print(findings, flush=True)
                found = True
            else:
                (passed / states[unit]).touch()
    for old in passed.iterdir():
        if old.name not in states.values():
            old.unlink()
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
