"""What is finished of a file that is written in blocks."""

from __future__ import annotations

import os
import sys
from types import TracebackType
from typing import BinaryIO

from heatwalk._errors import HeatwalkError
from heatwalk.dask._stores import Store, checksum

# What the log begins with, before the fingerprint.
MARK = "heatwalk dask 1"


class Part:
    """`FILE.part`, and `FILE.part.log` with a line for each block that is whole on the disk, its number and checksum.

    Opened, it takes up the blocks of an earlier run whose checksums are right, or begins. One process at a time has it.
    """

    def __init__(self, target: str, store: Store, fingerprint: str) -> None:
        self._target = target
        self.store = store
        self.finished: set[int] = set()
        self._rows = 0
        self._log_path = f"{store.path}.log"
        self._first = f"{MARK} {fingerprint}\n".encode()
        self._log = _open(self._log_path)
        try:
            if not self._resume():
                self._begin()
        except BaseException:
            self._log.close()
            raise

    def _begin(self) -> None:
        self._log.truncate(0)
        self.store.create()
        self._append(self._first)

    def _resume(self) -> bool:
        """Takes up the blocks that are whole. Returns whether anything was begun."""
        self._log.seek(0)
        first, *lines = self._log.read().splitlines(keepends=True) or [b""]
        # A line without an end was not written as a whole.
        if not first.endswith(b"\n"):
            return False
        if first != self._first:
            raise HeatwalkError(
                f"{self.store.path} was begun with another mesh, other places or other options; remove it and {self._log_path}, or "
                "choose another name",
                "another-matrix",
            )
        if not self.store.exists():
            return False
        if lines and not lines[-1].endswith(b"\n"):
            self._log.truncate(self._log.tell() - len(lines.pop()))
        for line in lines:
            self._take_up(line)
        return True

    def _take_up(self, line: bytes) -> None:
        try:
            block, expected = (int(word) for word in line.decode().split())
            if block in self.finished or not 0 <= block * self.store.rows < self.store.shape[0]:
                return
            found = checksum(self.store.read(block * self.store.rows))
        except (ValueError, OSError):
            return
        if found == expected:
            self._count(block)

    def _count(self, block: int) -> None:
        self.finished.add(block)
        self._rows += min(self.store.rows, self.store.shape[0] - block * self.store.rows)

    def _append(self, line: bytes) -> None:
        self._log.seek(0, os.SEEK_END)
        self._log.write(line)
        self._log.flush()
        os.fsync(self._log.fileno())

    def rows(self) -> int:
        """Rows that are finished."""
        return self._rows

    def kept(self) -> str:
        return f"{self._rows} of {self.store.shape[0]} rows are finished; the same call goes on from there"

    def add(self, block: int, found: int) -> None:
        """Notes a block that is on the disk."""
        self._append(f"{block} {found}\n".encode())
        self._count(block)

    def finish(self) -> None:
        """Takes the place of the file, once all blocks are finished."""
        self.store.sync()
        os.rename(self.store.path, self._target)
        self._log.close()
        os.remove(self._log_path)

    def __enter__(self) -> Part:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._log.close()


def _open(path: str) -> BinaryIO:
    """The log, which no other process has."""
    log = open(path, "a+b")  # noqa: SIM115
    if sys.platform != "win32":
        import fcntl

        try:
            fcntl.flock(log, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            log.close()
            raise HeatwalkError(f"{path} is being written by another run; wait for it", "busy") from None
        except OSError:
            # A file system without locks has to do without.
            pass
    return log
