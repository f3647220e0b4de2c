"""What ./run package makes: the Debian package in an empty root, the wheel in an empty environment."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["PREHEND_BUILD"])
SOURCE = pathlib.Path(os.environ["PREHEND_SOURCE"])
# What every Linux has: the run-time of C and C++.
RUN_TIME = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|util|stdc\+\+|gcc_s|resolv))\.so\.\d+$")


def printed(*words, **more):
    run = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False, **more)
    if run.returncode != 0:
        raise AssertionError(f"{words}: {run.returncode}\n{run.stdout}{run.stderr}")
    return run.stdout


def planned(program, folder, environment=None):
    """The bytes of grasps.json."""
    printed(program, "plan", "mug", "--trials", "100", "--no-report", "--out", folder,
            env=environment or {"PATH": "/nowhere"})
    return (folder / "grasps.json").read_bytes()


def machine_code(folder):
    for file in folder.rglob("*"):
        if file.is_file() and not file.is_symlink():
            with open(file, "rb") as opened:
                if opened.read(4) == b"\x7fELF":
                    yield file


def needed(binary):
    return re.findall(r"NEEDED\s+(\S+)", printed("objdump", "-p", binary))


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="prehend-packages-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.expected = planned(BUILD / "prehend", cls.folder / "expected")


class DebianPackage(Packages):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        printed("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder)
        [cls.package] = cls.folder.glob("prehend_*.deb")
        cls.root = cls.folder / "root"
        database = cls.root / "var/lib/dpkg"
        (database / "info").mkdir(parents=True)
        (database / "updates").mkdir()
        (database / "status").touch()
        printed("dpkg", f"--root={cls.root}", "--force-not-root", "--force-depends", "--log=/dev/null",
                "--unpack", cls.package, env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin"})

    def test_plans_in_an_empty_root(self):
        self.assertEqual(planned(self.root / "usr/bin/prehend", self.folder / "deb"), self.expected)

    def test_has_the_commands_of_the_other_programs(self):
        for command in ("serve", "batch"):
            self.assertIn(f"prehend {command}", printed(self.root / "usr/bin/prehend", command, "--help"))

    def test_plans_from_python(self):
        words = "import prehend; print(prehend.__file__, len(list(prehend.plan(prehend.load_scene('mug')))))"
        environment = {**os.environ, "PYTHONPATH": str(self.root / "usr/lib/python3/dist-packages")}
        file, count = printed("/usr/bin/python3", "-c", words, env=environment).split()
        self.assertTrue(file.startswith(str(self.root)), file)
        self.assertGreater(int(count), 0)

    def test_depends_on_all_that_its_binaries_are_linked_to(self):
        depends = {re.split(r"[ (:]", one.strip())[0]
                   for one in printed("dpkg-deb", "--field", self.package, "Depends").split(",")}
        own = {file.name for file in self.root.rglob("*.so*")}
        binaries = list(machine_code(self.root))
        self.assertGreater(len(binaries), 2)
        for binary in binaries:
            where = dict(re.findall(r"(\S+) => (/\S+)", printed("ldd", binary)))
            for name in set(needed(binary)) - own:
                if name.startswith("ld-linux"):
                    continue
                file = pathlib.Path(where[name]).resolve()
                # Debian lists files under /usr or, from before /lib became a link to it, without.
                names = [str(file), str(file).removeprefix("/usr"), where[name]]
                owners = subprocess.run(["dpkg-query", "--search", *names], check=False, text=True,
                                        capture_output=True).stdout
                found = {line.split(":")[0] for line in owners.splitlines()}
                self.assertTrue(found & depends, f"{binary.name} needs {name} of {found}, not in {depends}")

    def test_has_the_page_of_the_manual(self):
        page = (self.root / "usr/share/man/man1/prehend.1").read_bytes()
        self.assertEqual(page, (SOURCE / "planner/main/package/prehend.1").read_bytes())

    def test_completes_commands_options_and_names(self):
        script = self.root / "usr/share/bash-completion/completions/prehend"

        def completed(*words):
            program = self.root / "usr/bin/prehend"
            return printed("bash", "-c", 'source "$1"; COMP_WORDS=("$2" "${@:3}"); COMP_CWORD=$(($# - 2)); '
                           '_prehend "$2" "${@: -1}" "${@: -2:1}"; printf "%s\\n" "${COMPREPLY[@]}"',
                           "bash", script, program, *words).split()

        self.assertIn("plan", completed(""))
        self.assertEqual(completed("pl"), ["plan"])
        self.assertIn("--hand", completed("plan", "--"))
        self.assertIn("mug_on_table", completed("plan", "mug"))
        self.assertIn("barrett", completed("plan", "mug", "--hand", "b"))

    def test_has_headers_and_the_cmake_package(self):
        for name in ("include/prehend/prehend.h", "lib/libprehend.so", "lib/libprehend_quality.a",
                     "lib/cmake/prehend/prehendConfig.cmake", "share/doc/prehend/LICENSE"):
            self.assertTrue((self.root / "usr" / name).exists(), name)


class Wheel(Packages):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        printed("/usr/bin/python3", SOURCE / "planner/python/wheel/wheel_backend.py", cls.folder)
        [cls.wheel] = cls.folder.glob("prehend-*.whl")
        cls.venv = cls.folder / "venv"
        # NumPy is the system's: nothing is downloaded here.
        printed("/usr/bin/python3", "-m", "venv", "--system-site-packages", cls.venv)
        printed(cls.venv / "bin/pip", "install", "--no-index", "--disable-pip-version-check", cls.wheel)
        [cls.package] = cls.venv.glob("lib/python*/site-packages/prehend")

    def test_plans_by_its_command(self):
        self.assertEqual(planned(self.venv / "bin/prehend", self.folder / "wheel"), self.expected)

    def test_plans_from_python(self):
        words = "import prehend; print(prehend.__file__, len(list(prehend.plan(prehend.load_scene('mug')))))"
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        file, count = printed(self.venv / "bin/python", "-c", words, env=environment, cwd="/").split()
        self.assertTrue(file.startswith(str(self.venv)), file)
        self.assertGreater(int(count), 0)

    def test_stands_on_nothing_but_the_run_time(self):
        own = {file.name for file in (self.package.parent / "prehend.libs").iterdir()}
        binaries = list(machine_code(self.package.parent))
        self.assertGreater(len(binaries), len(own))
        for binary in binaries:
            for name in needed(binary):
                self.assertTrue(name in own or RUN_TIME.match(name), f"{binary.name} needs {name}")
            for name, file in re.findall(r"(\S+) => (/\S+)", printed("ldd", binary)):
                self.assertTrue(file.startswith(str(self.venv)) or RUN_TIME.match(name), f"{binary.name}: {file}")

    def test_uninstalls_without_a_trace(self):
        copy = self.folder / "copy"
        printed("/usr/bin/python3", "-m", "venv", "--system-site-packages", copy)
        pip = [copy / "bin/pip", "--disable-pip-version-check"]
        before = sorted(copy.rglob("*"))
        printed(*pip, "install", "--no-index", "--no-compile", self.wheel)
        printed(*pip, "uninstall", "--yes", "prehend")
        self.assertEqual([file for file in sorted(copy.rglob("*")) if "__pycache__" not in str(file)],
                         [file for file in before if "__pycache__" not in str(file)])


if __name__ == "__main__":
    for tool in ("dpkg", "dpkg-shlibdeps", "cpack", "patchelf", "file", "objdump"):
        if not shutil.which(tool):
            print(f"{tool} is missing: ./run test installs it", file=sys.stderr)
            sys.exit(1 if os.environ.get("CI") else 77)
    unittest.main()
