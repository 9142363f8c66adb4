"""Work in portions, on the workers of a Dask cluster."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, TypeVar

from carom import _carom
from carom.errors import CaromError

T = TypeVar("T")

#: Portions for each worker: so many that a slow one is not waited for long, so few that each takes its time.
PORTIONS = 4


def _counted(work: Callable[..., T], portion: int, of: int) -> T:
    """One portion, on a worker: its process computes with as many threads as the cluster gave it."""
    from distributed import get_worker

    threads = int(get_worker().state.nthreads)
    if _counted.__dict__.get("threads") != threads:
        _carom.use_threads(threads)
        _counted.__dict__["threads"] = threads
    return work(portion, of)


class Cluster:
    """The workers of a cluster, and what they took."""

    def __init__(self, client: Any) -> None:
        self.client = client
        self.begun = time.monotonic()
        if getattr(client, "status", "running") != "running" or not hasattr(client, "nthreads"):
            raise CaromError("client: expected a client of a Dask cluster that is running")
        try:
            threads = client.nthreads()
        except Exception as error:
            raise CaromError(f"client: expected a client of a Dask cluster that is running: {type(error).__name__}: {error}") from error
        if not threads:
            raise CaromError("client: the cluster has no workers")
        self.threads = sum(threads.values())
        self.portions = PORTIONS * len(threads)

    @property
    def seconds(self) -> float:
        """Since the work was begun [s]."""
        return time.monotonic() - self.begun

    def each(self, work: Callable[[int, int], T], hear: Callable[[int, int | None], object] | None) -> list[T]:
        """What the work gives of each portion, in order. A portion whose worker dies is done again by another one.

        Raises :class:`CaromError` of the work; and where the cluster does not finish it.
        """
        of = self.portions
        try:
            futures = self.client.map(_counted, [work] * of, range(of), [of] * of, pure=False)
        except Exception as error:
            raise _unfinished(error) from error
        try:
            found: list[T] = self._gathered(futures, hear)
            return found
        except CaromError:
            raise
        except Exception as error:
            raise _unfinished(error) from error
        finally:
            # Of what is finished nothing is left to cancel.
            self._cancelled(futures)

    def _gathered(self, futures: list[Any], hear: Callable[[int, int | None], object] | None) -> Any:
        import distributed

        completed: Any = distributed.as_completed
        for done, future in enumerate(completed(futures), 1):
            future.result()
            if hear is not None:
                hear(done, len(futures))
        return self.client.gather(futures)

    def _cancelled(self, futures: list[Any]) -> None:
        try:
            self.client.cancel([future for future in futures if not future.done()])
        except Exception:  # noqa: S110, BLE001
            # The cluster is gone: nobody is at work.
            return


def _unfinished(error: Exception) -> CaromError:
    return CaromError(f"the cluster did not finish: {type(error).__name__}: {error}")
