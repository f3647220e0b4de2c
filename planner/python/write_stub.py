"""Writes the stub of the extension module: python3 write_stub.py SOURCE TARGET

SOURCE is planner/python/prehend/_core.pyi, in which the line "# <options>" stands for the classes of
options. They are made from their declarations in C++, and so are their types here: those of the module
that lies beside TARGET.
"""

import importlib
import inspect
import pathlib
import sys
import types

MARK = "# <options>\n"


def load_core(folder):
    """The extension module, without the rest of the package, which needs NumPy."""
    package = types.ModuleType("prehend")
    package.__path__ = [str(folder)]
    sys.modules["prehend"] = package
    return importlib.import_module("prehend._core")


def class_stub(cls):
    name = cls.__name__
    fields = cls.__annotations__
    return "\n".join(
        [
            f"class {name}:",
            "    _fields: Tuple[str, ...]",
            *(f"    {field}: {type_name}" for field, type_name in fields.items()),
            "    def __init__(",
            "        self,",
            "        *,",
            *(f"        {field}: {type_name} = ...," for field, type_name in fields.items()),
            "    ) -> None: ...",
            f"    def __copy__(self) -> {name}: ...",
            f"    def __deepcopy__(self, memo: Dict[Any, Any], /) -> {name}: ...",
            "    def __setstate__(self, state: Dict[str, Any], /) -> None: ...",
            "",
            "",
        ]
    )


def options_stub(core):
    classes = [cls for cls in vars(core).values() if inspect.isclass(cls)]
    return "".join(class_stub(cls) for cls in classes if "_fields" in vars(cls))


def main():
    source, target = map(pathlib.Path, sys.argv[1:])
    text = source.read_text()
    if text.count(MARK) != 1:
        sys.exit(f"{source}: there must be one line {MARK!r}")
    stub = text.replace(MARK, options_stub(load_core(target.parent)).rstrip("\n") + "\n")
    target.unlink(missing_ok=True)
    target.write_text(stub)


if __name__ == "__main__":
    main()
