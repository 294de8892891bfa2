"""The notebooks run from the first cell to the last."""

import nbformat
import pytest
from conftest import PROJECT
from nbclient import NotebookClient

NOTEBOOKS = sorted((PROJECT / "docs/notebooks").glob("*.ipynb"))


def test_there_are_notebooks():
    assert NOTEBOOKS


@pytest.mark.parametrize("file", NOTEBOOKS, ids=[file.stem for file in NOTEBOOKS])
def test_notebook(file, tmp_path, monkeypatch):
    # nothing is left in the user's folder
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    notebook = nbformat.read(file, as_version=4)
    nbformat.validate(notebook)
    # stored without output, which would only become outdated
    assert all(not cell.outputs for cell in notebook.cells if cell.cell_type == "code")
    NotebookClient(notebook, timeout=300, startup_timeout=300, kernel_name="python3",
                   resources={"metadata": {"path": str(file.parent)}}).execute()
