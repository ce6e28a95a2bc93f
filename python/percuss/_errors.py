"""Exceptions of the package. They hold their parts as data and name options as keywords."""

from __future__ import annotations

from collections.abc import Sequence

from ._percuss import option_in_python

def _listed(text: str, options: Sequence[str]) -> str:
    """The text, followed by its options in parentheses. Options of other commands, "survey.example", follow "see"."""
    own = ", ".join(option_in_python(one) for one in options if "." not in one)
    others = ", ".join(option_in_python(one) for one in options if "." in one)
    shown = "; ".join([own] * bool(own) + [f"see {others}"] * bool(others))
    return f"{text} ({shown})" if shown else text


class InputError(ValueError):
    """Data or options that percuss cannot use.

    problem   what is wrong
    where     the file, array or value at fault; "" if the error has no place
    remedy    what to do
    options   identifiers of the options concerned, such as ("fs", "accel_channel")

    str() is one line, "problem (where); remedy (fs=, accel_channel=)".
    """

    def __init__(self, problem: str, where: str = "", remedy: str = "", options: Sequence[str] = ()) -> None:
        super().__init__(problem, where, remedy, tuple(options))

    @property
    def problem(self) -> str:
        """What is wrong."""
        return self.args[0]

    @property
    def where(self) -> str:
        """The file, array or value at fault; "" if the error has no place."""
        return self.args[1]

    @property
    def remedy(self) -> str:
        """What to do."""
        return self.args[2]

    @property
    def options(self) -> tuple[str, ...]:
        """Identifiers of the options concerned."""
        return self.args[3]

    def __str__(self) -> str:
        text = f"{self.problem} ({self.where})" if self.where else self.problem
        return _listed(f"{text}; {self.remedy}" if self.remedy else text, self.options)


class NoHitError(InputError):
    """No hit can be used, so there are no FRFs and no modes."""


class UsageError(InputError):
    """An option's value that percuss rejects, or options that exclude each other.

    problem, where, remedy, options  as in InputError; the options concerned are the subject of the problem
    value                            the rejected value as text, or "" if no single value is wrong
    """

    def __init__(
        self, problem: str, remedy: str = "", options: Sequence[str] = (), value: str = "", remedy_options: Sequence[str] = ()
    ) -> None:
        ValueError.__init__(self, problem, remedy, tuple(options), value, tuple(remedy_options))

    @property
    def problem(self) -> str:
        """What is wrong, with the options as keywords: "effort= cannot be 'bst'"."""
        names = [option_in_python(one) for one in self.args[2]]
        subject = " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)
        return f"{subject} {self.args[0]}" if subject else self.args[0]

    @property
    def where(self) -> str:
        """Always ""."""
        return ""

    @property
    def remedy(self) -> str:
        """What to do."""
        return self.args[1]

    @property
    def options(self) -> tuple[str, ...]:
        """Identifiers of the options concerned."""
        return self.args[2]

    @property
    def value(self) -> str:
        """The rejected value as text, or ""."""
        return self.args[3]

    def __str__(self) -> str:
        return _listed(f"{self.problem}; {self.remedy}" if self.remedy else self.problem, self.args[4])


def note_in_python(note: tuple[str, Sequence[str]]) -> str:
    """A note of the library, its options as keywords."""
    return _listed(*note)
