"""Fixtures for pytest, which finds them where Graze is installed; else `-p graze.pytest_plugin`::

    def test_mine(graze_check, graze_golden):
        graze_check(mine_for(graze_golden.solid, graze_golden.motion), graze_golden.scene)

`graze_check` is `graze.testing.check` with the points and the seed of the command line,
`--graze-n` and `--graze-seed`; `graze_golden` runs a test once for each golden case, `graze_case`
reads one by name, `graze_scene` gives a scene of the benchmark by name, written once and kept in
pytest's cache. SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import functools
import importlib
from typing import Any, Callable

pytest: Any = importlib.import_module("pytest")

N, SEED = 1000, 1


def _count(text: str) -> int:
    value = int(text)
    if value < 1:
        raise ValueError(text)
    return value


def _seed(text: str) -> int:
    value = int(text)
    if not 0 <= value < 2 ** 64:
        raise ValueError(text)
    return value


def pytest_addoption(parser: Any) -> None:
    """Options of the command line."""
    group = parser.getgroup("graze", "exact answers of Graze")
    group.addoption("--graze-n", type=_count, default=N, metavar="N", help=f"points that graze_check makes ({N})")
    group.addoption("--graze-seed", type=_seed, default=SEED, metavar="K", help=f"their seed ({SEED})")


def pytest_generate_tests(metafunc: Any) -> None:
    """A test that takes `graze_golden` runs once for each golden case."""
    if "graze_golden" in metafunc.fixturenames:
        from . import testing
        metafunc.parametrize("graze_golden", testing.case_names(), indirect=True)


@pytest.fixture  # type: ignore
def graze_check(request: Any) -> Callable[..., Any]:
    """`graze.testing.check` with the points and the seed of the command line."""
    from . import testing
    return functools.partial(testing.check, n=request.config.getoption("--graze-n"), seed=request.config.getoption("--graze-seed"))


@pytest.fixture  # type: ignore
def graze_golden(request: Any) -> Any:
    """One golden case after the other, each a `Case`."""
    from . import testing
    return testing.case(request.param)


@pytest.fixture(scope="session")  # type: ignore
def graze_case() -> Callable[[str], Any]:
    """A function that reads a golden case by name."""
    from . import testing
    return functools.lru_cache(maxsize=None)(testing.case)


@pytest.fixture(scope="session")  # type: ignore
def graze_scene(request: Any, tmp_path_factory: Any) -> Callable[[str], Any]:
    """A function that gives the `Scene` of a name of the benchmark; its files are written once."""
    from . import __version__, testing
    from .scene import Scene
    cache = getattr(request.config, "cache", None)
    folder = cache.mkdir(f"graze-{__version__}") if cache and hasattr(cache, "mkdir") else tmp_path_factory.mktemp("graze")

    @functools.lru_cache(maxsize=None)
    def made(name: str) -> Scene:
        return Scene(*testing.write_benchmark(name, folder))

    return made
