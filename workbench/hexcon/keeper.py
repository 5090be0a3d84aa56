# SPDX-License-Identifier: LGPL-2.1-or-later
"""What must not outlive this process: process groups and folders. A second process, the keeper, ends and removes them.

No handler sees SIGKILL, and none runs while a library crashes: so a small process waits at a pipe for the end of this
one, whatever ends it, and then cleans up what it was told of. It starts with the first thing it is told. Where there is
no Python to run it with, this process goes on without.

This file is both sides: imported, the one that tells; run as a program, the keeper.
"""
import atexit
import contextlib
import os
import shutil
import signal
import subprocess
import sys
import threading
import time

GRACE = 0.2         # seconds that a group has to end in order
PATIENCE = 5.0      # seconds in which a folder must be gone: what was killed may write into it for a moment


class _Keeper:
    """The pipe to the keeper, and what it was told."""

    def __init__(self):
        self._lock = threading.Lock()
        self._held = {}         # records in their order; of a dict only the keys count
        self._process = None

    def hold(self, record):
        with self._lock:
            self._held[record] = None
            self._tell(b"+" + record)

    def let_go(self, record):
        with self._lock:
            if record in self._held:
                del self._held[record]
                self._tell(b"-" + record)

    def _tell(self, line):
        """Write a line; a keeper that is gone, or not there yet, is started and told everything."""
        try:
            if self._process is not None:
                os.write(self._process.stdin.fileno(), line + b"\0")
                return
        except OSError:
            self._forget()
        if self._held:
            self._start()

    def _start(self):
        from .interpreter import is_python, python
        try:
            self._process = subprocess.Popen([sys.executable if is_python(sys.executable) else python(), "-I", "-S", os.path.abspath(__file__)],
                                             stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                             stderr=subprocess.DEVNULL, cwd=os.sep, bufsize=0, start_new_session=True)
            for record in self._held:
                os.write(self._process.stdin.fileno(), b"+" + record + b"\0")
        except (OSError, ValueError):
            self._forget()

    def _forget(self):
        process, self._process = self._process, None
        if process is None:
            return
        process.stdin.close()
        try:
            process.wait(PATIENCE + 1.0)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def close(self):
        """At the end of this process: all is cleaned up when this returns."""
        with self._lock:
            self._forget()

    def after_fork(self):
        """A fork holds nothing, and must not keep its parent's pipe open."""
        process = self._process
        self.__init__()
        if process is not None:
            process.stdin.close()
            process.returncode = 0      # it is not this process's child


def hold_group(number):
    """The process group of this number is killed when this process ends."""
    _keeper.hold(b"g%d" % number)


def let_group_go(number):
    _keeper.let_go(b"g%d" % number)


def hold_folder(path):
    """The folder, which may not exist yet, is removed when this process ends."""
    _keeper.hold(b"f" + os.fsencode(os.path.abspath(path)))


def let_folder_go(path):
    _keeper.let_go(b"f" + os.fsencode(os.path.abspath(path)))


# ------------------------------------------------------------------------------ the keeper's side
# (and end_group, which both have)

def _told(stream):
    """The records held when the stream ends."""
    held, rest = {}, b""
    while True:
        chunk = os.read(stream, 65536)
        if not chunk:
            return list(held)
        *lines, rest = (rest + chunk).split(b"\0")
        for line in lines:
            if line[:1] == b"+":
                held[line[1:]] = None
            else:
                held.pop(line[1:], None)


def end_group(number, reap=lambda: None):
    """End a process group: by SIGTERM, and what is there after GRACE seconds by SIGKILL.

    reap: waits for its leader without blocking, where that is this process's child: until then it counts as there.
    Xvfb needs the time, to take away its lock and socket. Windows has no groups: there its leader alone is ended.
    """
    if not hasattr(os, "killpg"):
        with contextlib.suppress(OSError):      # gone
            os.kill(number, signal.SIGTERM)
        return
    limit = time.monotonic() + GRACE
    try:
        os.killpg(number, signal.SIGTERM)
        while time.monotonic() < limit:
            time.sleep(0.002)
            reap()
            os.killpg(number, 0)
        os.killpg(number, signal.SIGKILL)
    except OSError:     # all gone
        pass


def _clean_up(held):
    for record in held:
        if record[:1] == b"g":
            end_group(int(record[1:]))
    for record in held:
        if record[:1] == b"f":
            _remove(os.fsdecode(record[1:]))


def _remove(folder):
    limit = time.monotonic() + PATIENCE
    while os.path.lexists(folder) and time.monotonic() < limit:
        shutil.rmtree(folder, ignore_errors=True)
        time.sleep(0.02)


if __name__ == "__main__":
    _clean_up(_told(0))
    sys.exit(0)

_keeper = _Keeper()
atexit.register(_keeper.close)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_keeper.after_fork)
