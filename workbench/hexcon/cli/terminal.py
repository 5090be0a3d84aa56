# SPDX-License-Identifier: LGPL-2.1-or-later
"""What surrounds a program: the streams it speaks on, which may be closed, full or narrow, and signals that end it."""
import argparse
import contextlib
import os
import signal
import sys
import tempfile

from hexcon import disk
from hexcon.errors import ToolError

EXIT_FAULT, EXIT_CLOSED, EXIT_SIGNAL = 1, 141, 128      # 141: as of a program that SIGPIPE ends; 128 + the signal's number
SIGNALS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]


class Stopped(KeyboardInterrupt):
    """A signal asked the program to end. `number` is the signal's."""

    def __init__(self, number):
        super().__init__(signal.Signals(number).name)
        self.number = number


def _stop(number, frame):
    signal.signal(number, signal.SIG_DFL)       # the second one ends the process at once; its keeper cleans up
    raise Stopped(number)


def run(main, name):
    """The exit status of main() as a program: what it raises, or cannot say, becomes words and a status.

    main  callable () -> exit status;  name: of the program, for words
    Files are written beside their places and put there when they are whole, so whatever ends the program,
    no file is half written.
    """
    _prepare_streams()
    before = _catch_signals()
    try:
        with _temporary_folder():
            status = main()
    except SystemExit as stop:      # argparse
        status = stop.code if isinstance(stop.code, int) else 2
    except KeyboardInterrupt as stop:
        number = getattr(stop, "number", signal.SIGINT)
        complain(f"{name}: ended by {signal.Signals(number).name}; no file is half written")
        status = EXIT_SIGNAL + number
    except MemoryError:
        complain(f"{name}: there is not enough memory; mesh coarser, or on a larger machine")
        status = EXIT_FAULT
    except _Unsaid as fault:
        status = _told(fault, name)
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    return _flushed(status, name)


@contextlib.contextmanager
def _temporary_folder():
    """One for all: FreeCAD leaves files of its own where temporary ones go if it cannot finish."""
    place, variable = tempfile.tempdir, os.environ.get("TMPDIR")
    try:
        folder = disk.new_folder("hexcon-")
    except ToolError:       # a full disk: that is told where the folder is needed
        yield
        return
    tempfile.tempdir = os.environ["TMPDIR"] = folder
    try:
        yield
    finally:
        tempfile.tempdir = place
        os.environ.pop("TMPDIR")
        if variable is not None:
            os.environ["TMPDIR"] = variable
        disk.remove_folder(folder)


def _catch_signals():
    """{signal: handler before} of those that are caught from now on: not what nohup, or a background job, ignores."""
    numbers = [number for number in SIGNALS if signal.getsignal(number) not in (signal.SIG_IGN, None)]
    return {number: signal.signal(number, _stop) for number in numbers}


class _Unsaid(Exception):
    """Standard output did not take the words; its cause is the OSError."""


def say(text):
    """Print on standard output, at once."""
    try:
        print(text, flush=True)
    except OSError as error:
        raise _Unsaid from error


def complain(text):
    """Print on standard error; where nobody can hear it, in vain."""
    try:
        print(text, file=sys.stderr, flush=True)
    except OSError:
        pass


class Parser(argparse.ArgumentParser):
    """argparse's, which speaks as everything else does here."""

    def print_help(self, file=None):
        say(self.format_help().rstrip("\n"))

    def error(self, message):
        complain(f"{self.format_usage()}{self.prog}: error: {message}")
        raise SystemExit(2)


def _flushed(status, name):
    """The status, or that of not being able to say what is still to be said."""
    try:
        sys.stdout.flush()
    except OSError as error:
        fault = _Unsaid()
        fault.__cause__ = error
        return _told(fault, name)
    return status


def _told(fault, name):
    """Status where standard output does not take the words. What is unsaid goes nowhere, or Python would try again."""
    error = fault.__cause__
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)
    if isinstance(error, BrokenPipeError):      # the reader has seen enough
        return EXIT_CLOSED
    complain(f"{name}: cannot write on standard output: {error.strerror or error}")
    return EXIT_FAULT


def _prepare_streams():
    """All three streams open, or a file that is opened next would be taken for one of them; and no name unprintable."""
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)      # the lowest number that is free
        if getattr(sys, name) is None:
            setattr(sys, name, open(number, "r" if name == "stdin" else "w", encoding="utf-8", closefd=False))
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
