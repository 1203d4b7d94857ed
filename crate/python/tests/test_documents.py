"""The examples of the documents: they run, and their types hold."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
DOCUMENTS = [ROOT / "docs" / "python.md", ROOT / "README.md"]


def examples(document: Path) -> str:
    blocks: list[str] = re.findall(r"^```python\n(.*?)^```", document.read_text(encoding="utf-8"), re.M | re.S)
    assert blocks, document
    return "\n".join(blocks)


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.name))
def test_examples_run(
    document: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Some write files.
    monkeypatch.chdir(tmp_path)
    exec(compile(examples(document), document.name, "exec"), {"__name__": "example"})


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.name))
def test_types_of_examples_hold(document: Path, tmp_path: Path) -> None:
    api = pytest.importorskip("mypy.api")
    example = tmp_path / "example.py"
    example.write_text(examples(document), encoding="utf-8")
    report, errors, status = api.run(["--strict", "--cache-dir", str(tmp_path / "cache"), str(example)])
    assert status == 0, report + errors
