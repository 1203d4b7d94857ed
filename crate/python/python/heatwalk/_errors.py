"""What goes wrong."""

from __future__ import annotations


class HeatwalkError(ValueError):
    """A question that cannot be answered: the message says what is at fault and what to do.

    `code` names the kind of failure in kebab case, such as "no-such-vertex". It stays the same between versions; messages
    may not.
    """

    code: str

    def __init__(self, message: str, code: str = "bad-parameter") -> None:
        super().__init__(message)
        self.code = code

    def __reduce__(self) -> tuple[type[HeatwalkError], tuple[str, str]]:
        return type(self), (str(self), self.code)
