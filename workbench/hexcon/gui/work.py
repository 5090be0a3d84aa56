# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work outside the window's thread, watched from it."""
import gc
import threading
import traceback

import FreeCAD
from PySide import QtCore

from hexcon_native import ErrorCode, HexconError

POLL = 50  # milliseconds between looks at the worker


class _CollectorRests:
    """Python's cycle collector off while any worker runs.

    It runs in whatever thread allocates, and a widget that it finds in a worker is destroyed
    outside the window's thread: FreeCAD dies. The workers' timers collect instead.
    """

    workers = 0
    was_on = False

    @classmethod
    def begin(cls):
        if cls.workers == 0:
            cls.was_on = gc.isenabled()
            gc.disable()
        cls.workers += 1

    @classmethod
    def end(cls):
        cls.workers -= 1
        if cls.workers == 0 and cls.was_on:
            gc.enable()


class Work:
    """One job in a thread.

    job       function(progress) -> result; progress(stage, fraction) returns False to stop it
    on_stage  function(stage, fraction), called in the window's thread
    on_end    function(result, fault), the same; fault is None or a HexconError. After cancel
              it is always a HexconError with code CANCELLED, even if the job was just done.
    No Qt object is touched by the thread: a timer of the window looks at plain attributes.
    """

    def __init__(self, job, on_stage, on_end):
        self._job, self._on_stage, self._on_end = job, on_stage, on_end
        self._latest = self._result = self._fault = None
        self._cancelled = threading.Event()
        self._thread = threading.Thread(target=self._run, name="HexCon", daemon=True)
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)

    def start(self):
        _CollectorRests.begin()
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self._abandon)
        self._thread.start()
        self._timer.start(POLL)

    def cancel(self):
        """Ask the job to stop; on_end follows."""
        self._cancelled.set()

    def _progress(self, stage, fraction):
        self._latest = (stage, fraction)
        return not self._cancelled.is_set()

    def _run(self):
        try:
            self._result = self._job(self._progress)
        except BaseException as fault:  # nothing may end in a traceback box
            self._fault = fault

    def _look(self):
        gc.collect(1)
        if self._thread.is_alive():
            if self._latest:
                self._on_stage(*self._latest)
            return
        self._timer.stop()
        QtCore.QCoreApplication.instance().aboutToQuit.disconnect(self._abandon)
        _CollectorRests.end()
        if self._cancelled.is_set():
            self._result, self._fault = None, HexconError("cancelled", ErrorCode.CANCELLED)
        result, fault = self._result, in_words(self._fault)
        self._job = self._result = self._fault = None
        self._on_end(result, fault)

    def _abandon(self):
        """FreeCAD closes: let the job end gmsh's process before Python is gone."""
        self.cancel()
        self._thread.join(5.0)


def in_words(fault):
    """A HexconError as it is; a defect of ours with its traceback in the report view."""
    if fault is None or isinstance(fault, HexconError):
        return fault
    FreeCAD.Console.PrintError("".join(traceback.format_exception(
        type(fault), fault, fault.__traceback__)))
    return HexconError(f"a defect in HexCon, please report it: {type(fault).__name__}: {fault} "
                       "(more in the report view)", None)
