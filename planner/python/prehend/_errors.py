"""The exceptions that prehend raises by itself."""


class InputError(ValueError):
    """A caller's mistake: what cannot be used, and why, in one line.

    Everything that a function takes is checked before any work is done.

    Attributes:
        file: the file that is at fault, or "" where there is none.
        field: the field of the file, or the argument of the call, or "".
        problem: what is wrong with it.
        value: the value as text, or "".
    """

    def __init__(
        self, problem: str, *, file: str = "", field: str = "", value: str = ""
    ) -> None:
        place = "".join(part + ": " for part in (file, field) if part)
        super().__init__(place + problem + (f" ({value})" if value else ""))
        self.file = file
        self.field = field
        self.problem = problem
        self.value = value


class Cancelled(Exception):
    """A long call was cancelled and has nothing to return."""
