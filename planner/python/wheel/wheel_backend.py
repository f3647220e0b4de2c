"""Builds the wheel: what pip calls for `pip install .` (PEP 517), and ./run package by

    wheel_backend.py FOLDER

The wheel has the Python package, the programs and what is found by name (robots, scenes, protocols). From
pip it stands on the libraries of this machine. From ./run package it contains copies of them, as auditwheel
makes them: all but those of the C and C++ run-time, which every machine has (manylinux). The copies have
names of their own, so that other extensions in the same process keep theirs.
"""

import base64
import contextlib
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

HOME = pathlib.Path(__file__).resolve().parents[3]
PROGRAMS = ("prehend", "prehend-live", "prehend-bulk")
DATA = ("robots", "benchmarks/scenes", "benchmarks/protocols")
RUN_TIME = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|util|stdc\+\+|gcc_s|resolv))\.so\.\d+$")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return make_wheel(pathlib.Path(wheel_directory), bundled=False)


def make_wheel(folder, bundled):
    build = build_all()
    with tempfile.TemporaryDirectory() as temporary:
        stage = pathlib.Path(temporary)
        binaries = stage_package(build, stage)
        if bundled:
            bundle(binaries, stage)
        info, tag = write_metadata(stage, bundled)
        name = f"{info.stem}-{tag}.whl"
        write_archive(stage, info, folder / name)
    return name


def build_all():
    """The build folder: that of ./run, if its Python is of the same version as this one."""
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    system = ["/usr/bin/python3", "-c", "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"]
    options = ["-D", f"PREHEND_PYTHON={sys.executable}"]
    build = HOME / "build" / f"python{sysconfig.get_python_version()}"
    with contextlib.suppress(OSError):
        if subprocess.run(system, capture_output=True, text=True, check=False).stdout.strip() == suffix:
            build, options = HOME / "build" / "release", []
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    for command in (["cmake", "-S", HOME, "-B", build, "--preset", "release", *options],
                    ["cmake", "--build", build, "--target", "prehend_python", "programs"]):
        subprocess.run(command, cwd=HOME, env=environment, stdout=sys.stderr, check=True)
    return build


def stage_package(build, stage):
    """Copies what the wheel has; returns the files that are machine code."""
    package = stage / "prehend"
    shutil.copytree(build / "python" / "prehend", package, ignore=shutil.ignore_patterns("__pycache__"))
    (package / "bin").mkdir()
    for program in PROGRAMS:
        if (build / program).exists():
            shutil.copy(build / program, package / "bin")
    for folder in DATA:
        shutil.copytree(HOME / folder, package / "share" / "prehend" / pathlib.Path(folder).name)
    binaries = [*package.glob("_core*.so"), *(package / "bin").iterdir()]
    subprocess.run(["strip", "--strip-unneeded", *binaries], check=True)
    return binaries


def needed_libraries(binary):
    """The libraries that the loader finds for a binary: names and files."""
    printed = subprocess.run(["ldd", binary], capture_output=True, text=True, check=True).stdout
    missing = re.findall(r"^\s*(\S+) => not found", printed, re.MULTILINE)
    if missing:
        raise RuntimeError(f"{binary.name} needs {', '.join(missing)}, which this machine does not have")
    return {name: pathlib.Path(file) for name, file in re.findall(r"^\s*(\S+) => (/\S+)", printed, re.MULTILINE)
            if not RUN_TIME.match(name)}


def bundle(binaries, stage):
    libraries = {}
    for binary in binaries:
        libraries |= needed_libraries(binary)
    folder = stage / "prehend.libs"
    folder.mkdir()
    renamed, copies = {}, []
    for name, file in libraries.items():
        content = file.read_bytes()
        stem, rest = name.split(".so", 1)
        renamed[name] = f"{stem}-{hashlib.sha256(content).hexdigest()[:8]}.so{rest}"
        copy = folder / renamed[name]
        copy.write_bytes(content)
        copy.chmod(0o755)
        copies.append(copy)
    replace = [word for pair in renamed.items() for word in ("--replace-needed", *pair)]
    for file in [*binaries, *copies]:
        path = os.path.relpath(folder, file.parent)
        changes = [replace, ["--set-rpath", "$ORIGIN" if path == "." else f"$ORIGIN/{path}"]]
        if file in copies:
            changes.append(["--set-soname", file.name])
        for change in changes:  # all at once, patchelf 0.14 mixes up their texts
            subprocess.run(["patchelf", *change, file], check=True)


def write_metadata(stage, bundled):
    """Returns the folder of the metadata and the wheel's tag."""
    project = tomllib.loads((HOME / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(prehend VERSION (\S+)", (HOME / "CMakeLists.txt").read_text()).group(1)
    info = stage / f"{project['name']}-{version}.dist-info"
    info.mkdir()
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}",
             *(f"Requires-Dist: {name}" for name in project["dependencies"]),
             "Description-Content-Type: text/markdown"]
    (info / "METADATA").write_text("\n".join(lines) + "\n\n" + (HOME / project["readme"]).read_text())
    machine = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    if bundled:  # for machines whose C library is not older than this one's
        glibc = os.confstr("CS_GNU_LIBC_VERSION").split()[1].replace(".", "_")
        machine = machine.replace("linux", f"manylinux_{glibc}", 1)
    python = f"cp{sysconfig.get_python_version().replace('.', '')}"
    tag = f"{python}-{python}-{machine}"
    (info / "WHEEL").write_text(
        f"Wheel-Version: 1.0\nGenerator: prehend\nRoot-Is-Purelib: false\nTag: {tag}\n")
    scripts = "".join(f"{name} = {call}\n" for name, call in project["scripts"].items())
    (info / "entry_points.txt").write_text("[console_scripts]\n" + scripts)
    shutil.copy(HOME / "LICENSE", info)
    return info, tag


def write_archive(stage, info, target):
    record = info / "RECORD"
    lines = []
    target.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(path for path in stage.rglob("*") if path.is_file() and path != record):
            name, content = file.relative_to(stage).as_posix(), file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            lines.append(f"{name},sha256={digest},{len(content)}")
            add(archive, name, content, 0o755 if os.access(file, os.X_OK) else 0o644)
        name = record.relative_to(stage).as_posix()
        add(archive, name, "\n".join([*lines, f"{name},,"]).encode() + b"\n", 0o644)


def add(archive, name, content, mode):
    entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))  # the same bytes whenever it is made
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = (0o100000 | mode) << 16
    archive.writestr(entry, content)


if __name__ == "__main__":
    print(pathlib.Path(sys.argv[1]) / make_wheel(pathlib.Path(sys.argv[1]).resolve(), bundled=True))
